package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ProfileCurve;

/** Builds push buttons without undersides, which are never visible. */
final class PushButtons {

  private PushButtons() {}

  /**
   * Returns an upright button with a rounded edge on y = 0, {@code segments (2 steps + 3)}
   * triangles.
   *
   * @param radiusX half its width; the rounding's radius is a third of the smaller half
   */
  static TriangleMesh round(
      double radiusX, double height, double radiusZ, int steps, int segments) {
    double edge = Math.min(height, Math.min(radiusX, radiusZ) / 3);
    ProfileCurve side =
        ProfileCurve.from(radiusX, -edge / 2)
            .line(radiusX, height - edge)
            .arc(radiusX - edge, height - edge, 90, steps)
            .line(0, height);
    return Lathe.surface(side, segments).scale(1, 1, radiusZ / radiusX);
  }
}
