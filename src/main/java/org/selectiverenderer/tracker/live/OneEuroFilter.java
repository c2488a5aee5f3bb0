package org.selectiverenderer.tracker.live;

import org.joml.Quaterniond;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerOptions;

/**
 * The one-euro filter on orientations: Casiez, Roussel and Vogel, "1 Euro filter: a simple
 * speed-based low-pass filter for noisy input in interactive systems", CHI 2012. Its step from the
 * old value to the new is taken along the shorter great arc, so that yaw may pass 180 degrees.
 */
final class OneEuroFilter implements PoseFilter {
  /** Of the low-pass on the speed, in Hz: the paper's constant. */
  private static final double SPEED_CUTOFF = 1;

  /** After a longer gap the old value says nothing; in seconds. */
  private static final double LONGEST_GAP = 0.5;

  private final TrackerOptions.Smoothing smoothing;
  private final Quaterniond raw = new Quaterniond();
  private final Quaterniond before = new Quaterniond();
  private final Quaterniond smooth = new Quaterniond();
  private double speed;
  private long last;
  private boolean begun;

  OneEuroFilter(TrackerOptions.Smoothing smoothing) {
    this.smoothing = smoothing;
  }

  @Override
  public void apply(PoseSample sample) {
    sample.orientation(raw);
    double dt = (sample.arrival() - last) * 1e-9;
    if (!begun || dt > LONGEST_GAP) {
      begun = true;
      last = sample.arrival();
      before.set(raw);
      smooth.set(raw);
      speed = 0;
      return;
    }
    // Records that arrive together have no time between them; a thousandth of a second stands in.
    double step = Math.max(dt, 1e-3);
    speed += share(SPEED_CUTOFF, step) * (Quaternions.angle(before, raw) / step - speed);
    double cutoff = smoothing.cutoff() + smoothing.speed() * speed;
    smooth.slerp(raw, share(cutoff, step)).normalize();
    before.set(raw);
    last = sample.arrival();
    sample.turn(smooth.x, smooth.y, smooth.z, smooth.w);
  }

  /** How much of the way to the new value a low-pass of first order goes in a time. */
  private static double share(double cutoff, double dt) {
    double tau = 1 / (2 * Math.PI * cutoff);
    return 1 / (1 + tau / dt);
  }
}
