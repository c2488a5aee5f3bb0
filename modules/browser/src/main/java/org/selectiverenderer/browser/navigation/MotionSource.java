package org.selectiverenderer.browser.navigation;

/** A source of motion requests: keys and mouse, a script, a test. */
@FunctionalInterface
public interface MotionSource {
  /**
   * Returns the motion requested for the coming frame; called once per frame.
   *
   * @param dt the duration of the frame in seconds
   */
  MotionRequest next(double dt);
}
