package org.selectiverenderer.runtime.walk;

/** Where the user's wishes come from: keys and mouse, a script, a test. */
@FunctionalInterface
public interface MotionSource {
  /**
   * What the user wants in the coming frame; asked once per frame.
   *
   * @param dt the frame's length in seconds
   */
  Motion next(double dt);
}
