package org.selectiverenderer.browser.viewer;

/**
 * The rectangle that an orthographic view shows at least, in the viewer's coordinates: the {@code
 * fieldOfView} of an OrthoViewpoint (X3D 4.0, 23.4.5). Also the cross-section of a view frustum at
 * distance 1.
 */
public record OrthographicExtent(double left, double bottom, double right, double top) {
  /** The default of OrthoViewpoint. */
  public static final OrthographicExtent DEFAULT = new OrthographicExtent(-1, -1, 1, 1);

  /**
   * Returns the extent given by the four numbers of a field; the default if they are too few or
   * span no area.
   */
  public static OrthographicExtent of(float[] field) {
    return field.length < 4 || !(field[0] < field[2]) || !(field[1] < field[3])
        ? DEFAULT
        : new OrthographicExtent(field[0], field[1], field[2], field[3]);
  }

  /**
   * Returns the extent widened on both sides until it has a given aspect ratio (width to height).
   */
  public OrthographicExtent filling(double aspect) {
    double width = Math.max(right - left, (top - bottom) * aspect);
    double height = Math.max(top - bottom, (right - left) / aspect);
    double x = (left + right) / 2;
    double y = (bottom + top) / 2;
    return new OrthographicExtent(x - width / 2, y - height / 2, x + width / 2, y + height / 2);
  }

  /** Returns the extent multiplied by a factor. */
  public OrthographicExtent times(double scale) {
    return new OrthographicExtent(left * scale, bottom * scale, right * scale, top * scale);
  }
}
