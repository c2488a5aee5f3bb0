package org.selectiverenderer.runtime.walk;

/**
 * What the user wants in a frame.
 *
 * @param forward -1 backward .. 1 forward, times the speed
 * @param strafe -1 left .. 1 right, times the speed
 * @param rise -1 down .. 1 up, times the speed; a walker does not rise
 * @param turn radians per second about the up axis, positive to the left
 * @param lookYaw radians to turn in this frame, positive to the left
 * @param lookPitch radians to turn in this frame, positive up
 * @param speedFactor times the speed of the NavigationInfo, not negative
 */
public record Motion(
    double forward,
    double strafe,
    double rise,
    double turn,
    double lookYaw,
    double lookPitch,
    double speedFactor) {

  /** Stands still. */
  public static final Motion NONE = new Motion(0, 0, 0, 0, 0, 0, 1);

  /** Straight ahead at the usual speed, -1..1. */
  public static Motion ahead(double forward) {
    return new Motion(forward, 0, 0, 0, 0, 0, 1);
  }
}
