package org.selectiverenderer.tracker.emulator;

import org.selectiverenderer.tracker.PoseSample;

/** The motion of an emulated head. */
public interface HeadMotion {
  /** A person on a swivel chair who looks left and right, a little up and down, with some tilt. */
  HeadMotion LOOKING_ABOUT =
      (t, into) ->
          into.turn(
              60 * Math.sin(2 * Math.PI * t / 8),
              15 * Math.sin(2 * Math.PI * t / 5),
              5 * Math.sin(2 * Math.PI * t / 3));

  /**
   * Sets the angles at a time.
   *
   * @param time seconds since the device was plugged in
   */
  void at(double time, PoseSample into);
}
