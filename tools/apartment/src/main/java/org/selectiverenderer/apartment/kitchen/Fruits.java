package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A china bowl, 0.28 m wide, with two apples, two oranges, a pear and two bananas. */
final class Fruits {
  private static final ModelMaterial ORANGE = ModelMaterial.satin(ModelColour.hex(0xDE8424));
  private static final ModelMaterial APPLE = ModelMaterial.glossy(ModelColour.hex(0xA8322A));
  private static final ModelMaterial PEAR = ModelMaterial.satin(ModelColour.hex(0xA9B04A));
  private static final ModelMaterial BANANA = ModelMaterial.satin(ModelColour.hex(0xE3BE47));
  private static final ModelMaterial STALK = ModelMaterial.matt(ModelColour.hex(0x5A4028));

  private Fruits() {}

  static ParametricModel model() {
    TriangleMesh stalk = stalk();
    return ModelPlacement.centred(
        "fruits",
        Part.of("bowl", Materials.BLUE_CHINA, bowl()),
        Part.of(
            "oranges",
            ORANGE,
            RoundSolidBuilder.ellipsoid(0.041, 0.039, 0.041, 13, 20).move(0.062, 0.07, -0.042),
            RoundSolidBuilder.ellipsoid(0.04, 0.038, 0.04, 13, 20).move(-0.004, 0.07, -0.07)),
        Part.of(
            "apples",
            APPLE,
            apple().turnX(12).move(-0.066, 0.034, 0.012),
            apple().turnZ(-14).move(0.03, 0.038, 0.04)),
        Part.of("pear", PEAR, pear().turnZ(38).turnY(-35).move(0.005, 0.088, 0.0)),
        Part.of("bananas", BANANA, banana(), banana().turnY(16).move(0.012, 0.004, 0.026)),
        Part.of(
            "stalks",
            STALK,
            stalk.turnX(12).move(-0.066, 0.098, 0.026),
            stalk.turnZ(-14).move(0.046, 0.101, 0.04),
            stalk.move(0, 0.093, 0).turnZ(38).turnY(-35).move(0.005, 0.088, 0)));
  }

  private static TriangleMesh bowl() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0.006, 0.045, 0.006, 0.047, 0, 0.056, 0, 0.058, 0.008)
            .spline(3, 0.1, 0.032, 0.132, 0.07, 0.139, 0.088)
            .arc(0.1345, 0.0895, 150, 4)
            .spline(3, 0.122, 0.072, 0.092, 0.04, 0.053, 0.019, 0, 0.013);
    return Lathe.solid(profile, 32);
  }

  /** Returns an apple, dented at both ends. */
  private static TriangleMesh apple() {
    ProfileCurve profile =
        ProfileCurve.from(0, 0.008)
            .spline(2, 0.014, 0.0, 0.031, 0.013, 0.039, 0.038, 0.033, 0.062, 0.017, 0.071)
            .spline(2, 0.006, 0.065, 0, 0.06);
    return Lathe.solid(profile, 18);
  }

  private static TriangleMesh pear() {
    ProfileCurve profile =
        ProfileCurve.from(0, 0)
            .spline(2, 0.02, 0.002, 0.036, 0.022, 0.034, 0.045, 0.021, 0.07, 0.015, 0.088)
            .spline(2, 0.009, 0.097, 0, 0.098);
    return Lathe.solid(profile, 18);
  }

  /** Returns a banana, bent and five-edged with a thin stem; it leans on the bowl's rim. */
  private static TriangleMesh banana() {
    Spine bend =
        Spine.smooth(
            2, -0.098, 0.128, 0.02, -0.085, 0.106, 0.03, -0.05, 0.087, 0.052, 0, 0.08, 0.078, 0.05,
            0.092, 0.09, 0.085, 0.115, 0.088);
    return Sweep.tube(
        bend, 10, t -> t < 0.12 ? 0.004 : 0.006 + 0.0115 * Math.sqrt(4 * (t - 0.1) * (1.06 - t)));
  }

  private static TriangleMesh stalk() {
    return Sweep.tube(Spine.smooth(2, 0, -0.012, 0, 0.001, 0, 0, 0.005, 0.014, 0), 0.0016, 6);
  }
}
