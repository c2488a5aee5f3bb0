package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A round white teapot with a blue lid, 0.25 m from spout to handle. */
final class Teapot {

  private Teapot() {}

  static ParametricModel model() {
    ProfileCurve belly =
        ProfileCurve.of(0, 0.004, 0.04, 0.004, 0.042, 0, 0.048, 0, 0.05, 0.005)
            .spline(3, 0.072, 0.032, 0.076, 0.06, 0.064, 0.092, 0.046, 0.108)
            .line(0.044, 0.113)
            .line(0.038, 0.113)
            .line(0.036, 0.108)
            .line(0, 0.108);
    ProfileCurve lid =
        ProfileCurve.of(0, 0.109, 0.041, 0.112, 0.042, 0.115)
            .spline(2, 0.03, 0.124, 0.01, 0.13, 0.006, 0.134)
            .spline(2, 0.0125, 0.144, 0.008, 0.152, 0, 0.153);
    return ModelPlacement.centred(
        "teapot",
        Part.of("pot", Materials.CHINA, Lathe.solid(belly, 28), spout(), handle()),
        Part.of("lid", Materials.BLUE_CHINA, Lathe.solid(lid, 20)));
  }

  private static TriangleMesh spout() {
    Spine bend =
        Spine.smooth(
            3, 0.05, 0.036, 0, 0.084, 0.05, 0, 0.104, 0.08, 0, 0.118, 0.108, 0, 0.138, 0.12, 0);
    return Sweep.tube(bend, 14, t -> 0.022 - 0.0145 * Math.sqrt(t));
  }

  private static TriangleMesh handle() {
    Spine ear =
        Spine.smooth(
            4, -0.052, 0.094, 0, -0.088, 0.106, 0, -0.115, 0.085, 0, -0.108, 0.052, 0, -0.066,
            0.032, 0);
    return Sweep.tube(ear, 9, t -> 0.0062 + 0.0025 * Math.abs(2 * t - 1));
  }
}
