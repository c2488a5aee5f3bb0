package org.selectiverenderer.browser.viewer;

import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;

/**
 * The orientation and scale of the bound viewpoint's coordinate system in the world. They define
 * the up direction and the size of the viewer (X3D 4.0, 23.2.4 and 23.4.4).
 *
 * @param upright the rotation from the viewpoint's coordinates, +Y up, to the world
 * @param scale the world units per unit of the viewpoint, above 0
 */
public record ViewpointFrame(Quaterniondc upright, double scale) {
  /** The frame of the world itself. */
  public static final ViewpointFrame WORLD = new ViewpointFrame(new Quaterniond(), 1);

  /**
   * Returns the frame of a viewpoint's coordinates.
   *
   * @param viewpoint the matrix from the coordinates of the viewpoint's fields to the world,
   *     without the viewpoint's own orientation
   */
  public static ViewpointFrame of(Matrix4dc viewpoint) {
    double scale = Math.cbrt(Math.abs(viewpoint.determinant3x3()));
    Quaterniond upright = viewpoint.getUnnormalizedRotation(new Quaterniond()).normalize();
    if (!(scale > 0) || !Double.isFinite(scale) || !upright.isFinite()) {
      return WORLD;
    }
    return new ViewpointFrame(upright, scale);
  }
}
