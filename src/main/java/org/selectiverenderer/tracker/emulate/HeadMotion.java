package org.selectiverenderer.tracker.emulate;

import org.selectiverenderer.tracker.PoseSample;

/** How an emulated head moves. */
public interface HeadMotion {
  /** Someone on a swivel chair who looks about: left and right, a little up, down and tilted. */
  HeadMotion LOOKING_ABOUT =
      (t, into) ->
          into.turn(
              60 * Math.sin(2 * Math.PI * t / 8),
              15 * Math.sin(2 * Math.PI * t / 5),
              5 * Math.sin(2 * Math.PI * t / 3));

  /**
   * Sets the angles at a time.
   *
   * @param time in seconds since the device was plugged in
   */
  void at(double time, PoseSample into);
}
