package org.selectiverenderer.app.run;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.app.headset.HeadsetAnswer;
import org.selectiverenderer.app.walk.Walkthrough;
import org.selectiverenderer.openxr.SpacePose;
import org.selectiverenderer.runtime.camera.Panel;
import org.selectiverenderer.runtime.render.window.KeyboardKey;
import org.selectiverenderer.runtime.viewer.ViewerMotion;
import org.selectiverenderer.runtime.walk.NavigationCommand;

/**
 * Leads a run: decides when it ends, how dark its picture is, which of the user's commands are
 * heard. All calls come from the thread that steps the world.
 */
public interface RunGuide {
  /** Nobody but the user, who sees all and may do everything. */
  RunGuide USER =
      new RunGuide() {
        @Override
        public boolean hears(NavigationCommand command) {
          return true;
        }
      };

  /** Whether a command of the user counts. A participant's only resets the head's heading. */
  default boolean hears(NavigationCommand command) {
    return command == NavigationCommand.RESET_HEADING;
  }

  /** A command was heard and is being done. */
  default void heard(NavigationCommand command) {}

  /**
   * A key of the operator that is none of the participant's: a function key.
   *
   * @param participants whether it was pressed in the participant's window
   */
  default void operatorKey(KeyboardKey key, boolean participants) {}

  /** Whether somebody asked since the last call for the heading to be reset. */
  default boolean takeHeadingReset() {
    return false;
  }

  /** Whether the pointer is kept in the participant's window, so that it presses nothing else. */
  default boolean keepsPointer() {
    return false;
  }

  /** Whether the operator is not to know the condition. */
  default boolean blind() {
    return false;
  }

  /** The scene is there, before its first frame. */
  default void opened(Walkthrough walk) {}

  /**
   * What moves the viewer.
   *
   * @param users what the user's mouse, keys and tracker do
   */
  default ViewerMotion motion(ViewerMotion users) {
    return users;
  }

  /** Whether the body goes where the user goes himself, when his head's place is tracked. */
  default boolean walks() {
    return true;
  }

  /**
   * Where the hand of the user of a headset points; each frame, before what he answers.
   *
   * @param hand where it is and points, along -Z, in the frame of the head and in metres; empty
   *     where there is none
   */
  default void pointed(Optional<SpacePose> hand) {}

  /** The user of a headset answered something by his controllers. */
  default void answered(HeadsetAnswer answer) {}

  /** Whether time stands still. */
  default boolean paused() {
    return false;
  }

  /**
   * Whether the run is over.
   *
   * @param seconds since its first frame, pauses not counted
   */
  default boolean over(double seconds) {
    return false;
  }

  /** How dark the picture is made: 0 not at all, 1 black. */
  default double darkness(double seconds) {
    return 0;
  }

  /** What the user of a headset is to read, later over earlier; only asked where he sees it. */
  default List<Panel> panels() {
    return List.of();
  }

  /**
   * Somebody closes a window of the run. Called by the window system's thread, unlike the others.
   *
   * @return whether it closes; else it stays until the run is {@link #over}
   */
  default boolean closing() {
    return true;
  }

  /** What the operator is told besides; the participant is not. */
  default List<String> operatorLines(double seconds) {
    return List.of();
  }
}
