package org.selectiverenderer.tracker.pipeline;

import org.selectiverenderer.tracker.PoseSample;

/**
 * The boresight of a tracker: the heading that counts as straight ahead. Yaw is the outermost of
 * the three rotations (order YXZ), so that subtracting from it rotates about the vertical axis
 * only.
 */
final class Boresight {
  /** A heading in degrees, with the number of resets so far. */
  private record Ahead(double yaw, int times) {
    Ahead next(double other) {
      return new Ahead(other, times + 1);
    }
  }

  private final LatestPose newest;
  private volatile Ahead ahead = new Ahead(0, 0);
  private volatile boolean wanted;

  public Boresight(LatestPose newest) {
    this.newest = newest;
  }

  /** Makes the heading of the latest pose yaw 0, or that of the first pose if there is none yet. */
  public void reset() {
    PoseSample now = new PoseSample();
    if (newest.read(now)) {
      ahead = ahead.next(now.yaw());
    } else {
      wanted = true;
    }
  }

  /** Makes the heading of the next pose yaw 0. */
  public void resetAtNext() {
    wanted = true;
  }

  /** Handles each pose before it is published. */
  public void arriving(PoseSample sample) {
    if (wanted) {
      ahead = ahead.next(sample.yaw());
      wanted = false;
    }
  }

  /** Copies the latest pose, relative to the boresight. */
  public boolean read(PoseSample into) {
    if (!newest.read(into)) {
      return false;
    }
    Ahead now = ahead;
    into.ahead(now.yaw());
    into.straightened(now.times());
    return true;
  }
}
