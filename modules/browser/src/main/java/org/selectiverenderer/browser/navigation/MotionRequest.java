package org.selectiverenderer.browser.navigation;

/**
 * The motion that the user requests in a frame.
 *
 * @param forward the forward motion, -1 (backward) to 1, times the speed
 * @param strafe the sideways motion, -1 (left) to 1 (right), times the speed
 * @param rise the vertical motion, -1 (down) to 1 (up), times the speed; ignored in WALK
 * @param turn the rotation about the up axis in radians per second, positive to the left
 * @param lookYaw the yaw in this frame in radians, positive to the left
 * @param lookPitch the pitch in this frame in radians, positive up
 * @param speedFactor the factor of the NavigationInfo's speed, not negative
 */
public record MotionRequest(
    double forward,
    double strafe,
    double rise,
    double turn,
    double lookYaw,
    double lookPitch,
    double speedFactor) {

  /** No motion. */
  public static final MotionRequest NONE = new MotionRequest(0, 0, 0, 0, 0, 0, 1);

  /** Returns motion straight ahead at a share of the normal speed, -1..1. */
  public static MotionRequest ahead(double forward) {
    return new MotionRequest(forward, 0, 0, 0, 0, 0, 1);
  }
}
