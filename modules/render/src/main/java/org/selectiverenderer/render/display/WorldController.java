package org.selectiverenderer.render.display;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.HeadFixedPage;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.window.InputEvent;

/**
 * The owner of the world that a window or headset shows: it steps the world and handles input. All
 * calls come from the render thread unless stated otherwise.
 */
public interface WorldController {
  /**
   * Called once before the windows are shown, on the thread that opens them. An action that shall
   * run before the windows are taken away at the end of the process can be registered from here on.
   */
  default void opening() {}

  /** Handles the user's input; called before the next {@link #step()}. */
  void input(InputEvent event);

  /** Handles input in the operator's window, which must not move the participant. */
  default void operatorInput(InputEvent event) {}

  /** Returns whether the pointer is confined to the participant's window. */
  default boolean pointerKept() {
    return false;
  }

  /**
   * Tells whether the user sees frames now; called before each {@link #step()} where that may
   * change, as with a headset that is put on and taken off.
   */
  default void presented(boolean seen) {}

  /** Steps the world for the next frame; returns empty while there is nothing to show yet. */
  Optional<World> step();

  /**
   * Returns whether all of a world is uploaded before its first picture, so that all later frames
   * take equally long; otherwise hidden shapes are uploaded with the frames after it.
   */
  default boolean readyAtOnce() {
    return false;
  }

  /** Returns whether the window is to be closed instead of showing another frame. */
  boolean finished();

  /**
   * Called by the window system's thread, unlike the others, when the user closes a window.
   *
   * @return whether it closes; otherwise it stays until the host is {@link #finished}
   */
  default boolean closing() {
    return true;
  }

  /** Returns the lines of the text overlay; none for no overlay. */
  List<String> overlay();

  /** Returns the text that is shown while there is no world yet; none for a black picture. */
  default List<String> waiting() {
    return List.of("Loading the scene ...");
  }

  /** Returns how much the picture is darkened for all eyes: 0 not at all, 1 to black. */
  default double darkness() {
    return 0;
  }

  /**
   * Returns the panels of text for the user of a headset, drawn over the darkened picture, later
   * over earlier. Asked after each {@link #step()}, and only if the frame will be displayed.
   */
  default List<WorldSpacePanel> panels() {
    return List.of();
  }

  /**
   * Returns the page for the user of a window, drawn over the darkened picture; a headset shows
   * {@link #panels()} instead.
   */
  default Optional<HeadFixedPage> page() {
    return Optional.empty();
  }

  /** Called when a frame of the world was drawn and is about to be shown. */
  void drawn(FrameStatistics drawn);

  /** Called when that frame was handed to the display, in all windows. */
  default void submitted() {}

  /**
   * Returns the page of the operator's window, where there is one.
   *
   * @param width the width of that window in pixels
   * @param height the height of that window in pixels
   * @param pictureWidth the width of the participant's picture
   * @param pictureHeight the height of the participant's picture
   */
  default OperatorPage operatorPage(int width, int height, int pictureWidth, int pictureHeight) {
    return new OperatorPage(0, 0, width, height, List.of());
  }
}
