package org.selectiverenderer.tracker.pipeline;

import org.joml.Quaterniond;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerOptions;

/**
 * The one-euro filter on orientations: Casiez, Roussel and Vogel, "1 Euro filter: a simple
 * speed-based low-pass filter for noisy input in interactive systems", CHI 2012. It interpolates
 * along the shorter great arc (slerp), so that yaw may pass 180 degrees.
 */
final class OneEuroFilter implements PoseFilter {
  /** Cutoff of the low-pass filter of the speed in Hz, the constant of the paper. */
  private static final double SPEED_CUTOFF = 1;

  /** Gap in seconds after which the filter restarts. */
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
    // Records that arrive together have an interval of 0, for which 1 ms is substituted.
    double step = Math.max(dt, 1e-3);
    speed += share(SPEED_CUTOFF, step) * (QuaternionMath.angle(before, raw) / step - speed);
    double cutoff = smoothing.cutoff() + smoothing.speed() * speed;
    smooth.slerp(raw, share(cutoff, step)).normalize();
    before.set(raw);
    last = sample.arrival();
    sample.turn(smooth.x, smooth.y, smooth.z, smooth.w);
  }

  /** Returns the smoothing factor of a first-order low-pass filter for a time step. */
  private static double share(double cutoff, double dt) {
    double tau = 1 / (2 * Math.PI * cutoff);
    return 1 / (1 + tau / dt);
  }

  /** Quaternion functions that JOML lacks. */
  private static final class QuaternionMath {
    private QuaternionMath() {}

    /** Returns the angle of the rotation from one orientation to another, 0 to pi. */
    static double angle(Quaterniond from, Quaterniond to) {
      // By the distance of the quaternions: exact for small angles, where an arc cosine is not.
      double sign = from.dot(to) < 0 ? -1 : 1;
      double dx = sign * to.x - from.x;
      double dy = sign * to.y - from.y;
      double dz = sign * to.z - from.z;
      double dw = sign * to.w - from.w;
      double chord = Math.sqrt(dx * dx + dy * dy + dz * dz + dw * dw);
      return 4 * Math.asin(Math.min(1, chord / 2));
    }
  }
}
