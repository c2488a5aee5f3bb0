package org.selectiverenderer.enricher.preview;

/**
 * How a version is looked at. All of it is in the picture, whatever its size.
 *
 * @param width of the picture in pixels
 * @param height of the picture in pixels
 * @param yaw radians by which the eye looks to the left of -Z
 * @param pitch radians by which it looks up
 * @param wireframe whether only edges of polygons are drawn
 */
public record VersionLook(int width, int height, double yaw, double pitch, boolean wireframe) {
  private static final double YAW = Math.toRadians(30);
  private static final double PITCH = Math.toRadians(-20);

  /** From before, somewhat from the right and from above. */
  public static VersionLook solid(int width, int height) {
    return new VersionLook(width, height, YAW, PITCH, false);
  }

  /** From where {@link #solid} looks. */
  public static VersionLook wireframe(int width, int height) {
    return new VersionLook(width, height, YAW, PITCH, true);
  }
}
