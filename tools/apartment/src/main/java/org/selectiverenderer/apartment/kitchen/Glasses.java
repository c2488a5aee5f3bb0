package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/**
 * Two wine glasses and two tumblers: four lathes of 32 steps and 20 points, 32 * 2 * 18 = 1152
 * triangles each.
 */
final class Glasses {

  private Glasses() {}

  static ParametricModel model() {
    TriangleMesh wine = wineGlass();
    TriangleMesh tumbler = tumbler();
    return ModelPlacement.centred(
        "glasses",
        Part.of(
            "wineGlasses", Materials.GLASS, wine.move(-0.085, 0, -0.03), wine.move(0.02, 0, -0.05)),
        Part.of(
            "tumblers",
            Materials.GLASS,
            tumbler.move(-0.03, 0, 0.055),
            tumbler.move(0.085, 0, 0.04)));
  }

  private static TriangleMesh wineGlass() {
    return Lathe.solid(
        ProfileCurve.of(0, 0, 0.036, 0, 0.037, 0.0015, 0.02, 0.004, 0.0055, 0.011, 0.0042, 0.03)
            .line(0.0042, 0.078)
            .line(0.008, 0.088)
            .spline(1, 0.024, 0.098, 0.0375, 0.118, 0.0405, 0.14, 0.0375, 0.168, 0.033, 0.188)
            .line(0.0318, 0.188)
            .spline(1, 0.0362, 0.168, 0.039, 0.14, 0.036, 0.12, 0.022, 0.1, 0, 0.094),
        32);
  }

  private static TriangleMesh tumbler() {
    return Lathe.solid(
        ProfileCurve.of(0, 0.0015, 0.022, 0.0015, 0.0245, 0, 0.0285, 0, 0.031, 0.002, 0.0325, 0.007)
            .line(0.0345, 0.03)
            .line(0.0365, 0.06)
            .line(0.0385, 0.09)
            .line(0.0391, 0.0955)
            .line(0.0385, 0.0965)
            .line(0.0375, 0.0955)
            .line(0.0368, 0.09)
            .line(0.0348, 0.06)
            .line(0.0328, 0.03)
            .line(0.0315, 0.018)
            .line(0.0295, 0.0135)
            .line(0.025, 0.0115)
            .line(0.013, 0.0105)
            .line(0, 0.01),
        32);
  }
}
