package org.selectiverenderer.tracker.live;

import org.selectiverenderer.tracker.PoseSample;

/**
 * The heading that counts as straight ahead. Yaw is the outermost of the three rotations (order
 * YXZ), so that taking a number from it turns the world about its vertical axis and nothing else.
 */
final class Boresight {
  /** A heading in degrees, and which one it is. */
  private record Ahead(double yaw, int times) {
    Ahead next(double other) {
      return new Ahead(other, times + 1);
    }
  }

  private final NewestPose newest;
  private volatile Ahead ahead = new Ahead(0, 0);
  private volatile boolean wanted;

  public Boresight(NewestPose newest) {
    this.newest = newest;
  }

  /** Makes the newest pose's heading yaw 0, or that of the first pose when there is none yet. */
  public void reset() {
    PoseSample now = new PoseSample();
    if (newest.read(now)) {
      ahead = ahead.next(now.yaw());
    } else {
      wanted = true;
    }
  }

  /** Makes the next pose's heading yaw 0. */
  public void resetAtNext() {
    wanted = true;
  }

  /** Called with each pose before it is published. */
  public void arriving(PoseSample sample) {
    if (wanted) {
      ahead = ahead.next(sample.yaw());
      wanted = false;
    }
  }

  /** Copies the newest pose, relative to the heading ahead. */
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
