package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/**
 * A baseball bat, 0.84 m long, lying along x on its barrel and its knob. One of the objects that no
 * kitchen is expected to have (thesis, Appendix B).
 */
final class BaseballBat {

  /** Tilt with which barrel and knob both touch the floor, degrees. */
  private static final double TILT = 0.65;

  private BaseballBat() {}

  static ParametricModel model() {
    ProfileCurve wood =
        ProfileCurve.from(0.0125, 0.29)
            .spline(2, 0.016, 0.4, 0.024, 0.5, 0.031, 0.62)
            .line(0.0335, 0.74)
            .line(0.033, 0.8)
            .line(0.029, 0.825)
            .line(0.018, 0.839)
            .line(0, 0.842);
    ProfileCurve tape =
        ProfileCurve.of(0, 0, 0.019, 0.001, 0.025, 0.008, 0.024, 0.017, 0.015, 0.027, 0.0132, 0.045)
            .line(0.0135, 0.29)
            .line(0, 0.29);
    return ModelPlacement.centred(
        "baseballBat",
        Part.of("wood", Materials.LIGHT_OAK, lying(Lathe.solid(wood, 15))),
        Part.of("tape", Materials.SOFT_BLACK, lying(Lathe.solid(tape, 13))));
  }

  private static TriangleMesh lying(TriangleMesh upright) {
    return upright.turnZ(-90 + TILT);
  }
}
