package org.selectiverenderer.app;

import java.util.List;
import org.selectiverenderer.runtime.navigation.ViewerMotion;

/**
 * Leads a run that nobody ends for himself: a step of a session. With a guide the participant's
 * picture shows nothing but the scene, and of the commands only that about the head's heading is
 * heard. All calls come from the render thread.
 */
public interface RunGuide {
  /** The scene is there, before its first frame. */
  void opened(Walkthrough walk);

  /**
   * What moves the viewer.
   *
   * @param users what the user's mouse, keys and tracker do
   */
  ViewerMotion motion(ViewerMotion users);

  /** Whether time stands still. */
  boolean paused();

  /**
   * Whether the run is over.
   *
   * @param seconds since its first frame, pauses not counted
   */
  boolean over(double seconds);

  /** How dark the picture is made: 0 not at all, 1 black. */
  double darkness(double seconds);

  /**
   * Somebody closes a window of the run. Called by the window system's thread, unlike the others.
   *
   * @return whether it closes; else it stays until the run is {@link #over}
   */
  boolean closing();

  /** What the operator is told besides; the participant is not. */
  List<String> operatorLines(double seconds);
}
