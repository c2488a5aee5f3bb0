package org.selectiverenderer.enricher.preview;

/**
 * Size, direction and style of a version's picture; the camera frames the whole model.
 *
 * @param width of the picture in pixels
 * @param height of the picture in pixels
 * @param yaw radians by which the camera looks to the left of -Z
 * @param pitch radians by which the camera looks up
 * @param wireframe whether only the edges of polygons are drawn
 */
public record VersionImageSpec(int width, int height, double yaw, double pitch, boolean wireframe) {
  private static final double YAW = Math.toRadians(30);
  private static final double PITCH = Math.toRadians(-20);

  /** A solid picture, seen from the front, slightly from the right and above. */
  public static VersionImageSpec solid(int width, int height) {
    return new VersionImageSpec(width, height, YAW, PITCH, false);
  }

  /** A wireframe picture from the same direction as {@link #solid}. */
  public static VersionImageSpec wireframe(int width, int height) {
    return new VersionImageSpec(width, height, YAW, PITCH, true);
  }
}
