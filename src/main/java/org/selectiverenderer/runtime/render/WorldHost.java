package org.selectiverenderer.runtime.render;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.render.window.InputEvent;

/** Whoever runs the world that a window shows. All calls come from the render thread. */
public interface WorldHost {
  /** The user did something. Comes before the next {@link #step()}. */
  void input(InputEvent event);

  /** Steps the world for the next frame; empty while there is nothing to show yet. */
  Optional<World> step();

  /** Whether the window is to be closed instead of showing another frame. */
  boolean finished();

  /** The lines of the overlay; none for no overlay. */
  List<String> overlay();

  /** A frame of the world was drawn and is about to be shown. */
  void drawn(Drawn drawn);

  /** That frame was handed to the display, in all windows. */
  default void submitted() {}

  /**
   * What the operator's window shows, where there is one.
   *
   * @param width of that window in pixels
   * @param height of that window in pixels
   * @param pictureWidth of what the participant sees
   * @param pictureHeight of what the participant sees
   */
  default OperatorPage operatorPage(int width, int height, int pictureWidth, int pictureHeight) {
    return new OperatorPage(0, 0, width, height, List.of());
  }
}
