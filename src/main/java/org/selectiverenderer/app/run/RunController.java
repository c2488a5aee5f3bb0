package org.selectiverenderer.app.run;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.app.headset.ControllerCommand;
import org.selectiverenderer.browser.camera.HeadFixedPage;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.browser.navigation.NavigationCommand;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.openxr.XrPose;
import org.selectiverenderer.render.window.KeyboardKey;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Controls a run from outside, as a step of a session does: decides when the run ends, how dark its
 * picture is, and which commands of the user are accepted. All calls but {@link #closing} come from
 * the thread that steps the world.
 */
public interface RunController {
  /** The guide of a run without a session: the user's commands are all accepted. */
  RunController USER =
      new RunController() {
        @Override
        public boolean hears(NavigationCommand command) {
          return true;
        }
      };

  /**
   * Returns whether a command of the user is accepted. Of a participant only the reset of the
   * heading is.
   */
  default boolean hears(NavigationCommand command) {
    return command == NavigationCommand.RESET_HEADING;
  }

  /** Reports that a command was accepted and is being executed. */
  default void heard(NavigationCommand command) {}

  /**
   * Reports a function key, which belongs to the operator, not to the participant.
   *
   * @param participants whether it was pressed in the participant's window
   */
  default void operatorKey(KeyboardKey key, boolean participants) {}

  /** Returns whether a reset of the heading was requested since the last call. */
  default boolean takeHeadingReset() {
    return false;
  }

  /**
   * Returns whether the pointer is confined to the participant's window, so that it clicks nothing
   * else.
   */
  default boolean keepsPointer() {
    return false;
  }

  /** Returns whether the condition is hidden from the operator. */
  default boolean blind() {
    return false;
  }

  /** Reports that the scene is loaded, before its first frame. */
  default void opened(Walkthrough walk) {}

  /**
   * Returns the motion of the viewer.
   *
   * @param users the motion by the user's mouse, keys and tracker
   */
  default ViewerMotion motion(ViewerMotion users) {
    return users;
  }

  /** Returns whether the viewer's body follows a user whose head position is tracked. */
  default boolean walks() {
    return true;
  }

  /**
   * Reports the pose of the pointing hand of a headset's user; called for each frame, before the
   * answers.
   *
   * @param hand pose of the hand in head coordinates and metres, pointing along -Z; empty where
   *     there is none
   */
  default void pointed(Optional<XrPose> hand) {}

  /** Reports an answer that the user of a headset gave with the controllers. */
  default void answered(ControllerCommand answer) {}

  /**
   * Reports how the tracker is, with each frame.
   *
   * @param silent a sentence that the tracker is silent; empty while its records arrive
   */
  default void tracked(Optional<String> silent) {}

  /** Returns whether the run is paused. */
  default boolean paused() {
    return false;
  }

  /**
   * Returns whether the run is over.
   *
   * @param seconds since its first frame, pauses not counted
   */
  default boolean over(double seconds) {
    return false;
  }

  /** Returns how much the picture is darkened, from 0 (not at all) to 1 (black). */
  default double darkness(double seconds) {
    return 0;
  }

  /**
   * Returns the text panels of a headset's user, later ones over earlier ones; called only when the
   * picture is seen.
   */
  default List<WorldSpacePanel> panels() {
    return List.of();
  }

  /** Returns the page of a window's user; called only when the picture is seen. */
  default Optional<HeadFixedPage> page() {
    return Optional.empty();
  }

  /**
   * Reports that a key went down in the participant's window, before the scene and the navigation
   * get it.
   *
   * @param character the character that it produced; empty for none
   * @param nanos when it went down, as {@link System#nanoTime()}
   * @return whether nobody else gets it
   */
  default boolean pressed(KeyboardKey key, String character, long nanos) {
    return false;
  }

  /**
   * Reports that a window of the run is being closed. Unlike the other methods it is called by the
   * thread of the window system.
   *
   * @return whether the window closes; otherwise it stays until the run is {@link #over}
   */
  default boolean closing() {
    return true;
  }

  /** Returns additional lines for the operator's window. */
  default List<String> operatorLines(double seconds) {
    return List.of();
  }
}
