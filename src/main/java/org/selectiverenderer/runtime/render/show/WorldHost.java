package org.selectiverenderer.runtime.render.show;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.camera.Panel;
import org.selectiverenderer.runtime.render.Drawn;
import org.selectiverenderer.runtime.render.window.InputEvent;

/** Whoever runs the world that a window shows. All calls come from the render thread. */
public interface WorldHost {
  /**
   * All windows are open; once, before their first picture. A headset may have shown frames before.
   */
  default void started() {}

  /** The user did something. Comes before the next {@link #step()}. */
  void input(InputEvent event);

  /**
   * Somebody did something in the operator's window; the participant, who did not, must not move by
   * it.
   */
  default void operatorInput(InputEvent event) {}

  /** Whether the pointer is kept in the participant's window. */
  default boolean pointerKept() {
    return false;
  }

  /**
   * Whether the user sees frames now; before each {@link #step()} where that may change by itself,
   * as with a headset that is put on and taken off.
   */
  default void presented(boolean seen) {}

  /** Steps the world for the next frame; empty while there is nothing to show yet. */
  Optional<World> step();

  /**
   * Whether all of a world is sent to the graphics card before its first picture, so that all other
   * frames take alike long; else what is not shown comes with the frames after it.
   */
  default boolean readyAtOnce() {
    return false;
  }

  /** Whether the window is to be closed instead of showing another frame. */
  boolean finished();

  /**
   * The user closes a window. Called by the window system's thread, unlike the others.
   *
   * @return whether it closes; else it stays until the host is {@link #finished}
   */
  default boolean closing() {
    return true;
  }

  /** The lines of the overlay; none for no overlay. */
  List<String> overlay();

  /** What is shown while there is nothing to show; none for a black picture. */
  default List<String> waiting() {
    return List.of("Loading the scene ...");
  }

  /** How much the picture is darkened for all eyes: 0 not at all, 1 to black. */
  default double darkness() {
    return 0;
  }

  /**
   * What the user of a headset is to read, over the darkened picture, later over earlier. After
   * each {@link #step()}, and only where a frame will be seen.
   */
  default List<Panel> panels() {
    return List.of();
  }

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
