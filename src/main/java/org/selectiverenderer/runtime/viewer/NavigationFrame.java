package org.selectiverenderer.runtime.viewer;

import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;

/**
 * How the bound viewpoint's coordinates lie in the world: they say which way is up and how large
 * the viewer is, not where it is (X3D 4.0, 23.2.4 and 23.4.4).
 *
 * @param upright takes directions of the viewpoint's coordinates, +Y up, to the world
 * @param scale the world's units per unit of the viewpoint, above 0
 */
public record NavigationFrame(Quaterniondc upright, double scale) {
  /** That of the world itself. */
  public static final NavigationFrame WORLD = new NavigationFrame(new Quaterniond(), 1);

  /**
   * The frame of a viewpoint's place.
   *
   * @param viewpoint from the coordinates in which its fields are given to the world; the
   *     viewpoint's own orientation is no part of it
   */
  public static NavigationFrame of(Matrix4dc viewpoint) {
    double scale = Math.cbrt(Math.abs(viewpoint.determinant3x3()));
    Quaterniond upright = viewpoint.getUnnormalizedRotation(new Quaterniond()).normalize();
    if (!(scale > 0) || !Double.isFinite(scale) || !upright.isFinite()) {
      return WORLD;
    }
    return new NavigationFrame(upright, scale);
  }
}
