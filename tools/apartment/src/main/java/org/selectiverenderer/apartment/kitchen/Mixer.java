package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * A red stand mixer, 0.36 m long and high, seen from its lever's side: its head reaches to the
 * right over a steel bowl with a whisk.
 */
final class Mixer {
  /** The x of the axis of bowl and whisk, metres. */
  private static final double BOWL_X = 0.075;

  private Mixer() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        "mixer",
        Part.of("body", Materials.BRICK_RED, base(), column(), head()),
        Part.of("steel", Materials.POLISHED_STEEL, bowl(), bowlHandle(), whisk(), hub(), cap()),
        Part.of("lever", Materials.SOFT_BLACK, lever()));
  }

  private static TriangleMesh base() {
    return ExtrudedSolid.plate(0.034, 0.015, 7, SimplePolygon.superellipse(0.175, 0.108, 2.8, 96));
  }

  /** Returns the column, narrower in the middle than at the foot and below the head. */
  private static TriangleMesh column() {
    return Sweep.of(
        SimplePolygon.superellipse(0.05, 0.045, 2.6, 72),
        Spine.smooth(
            6, -0.108, 0.02, 0, -0.112, 0.08, 0, -0.112, 0.14, 0, -0.105, 0.2, 0, -0.098, 0.265, 0),
        t -> 0.92 + 0.9 * (t - 0.6) * (t - 0.6));
  }

  /** Returns the head, shaped like a bullet along x: round behind, cut off in front. */
  private static TriangleMesh head() {
    ProfileCurve profile =
        ProfileCurve.from(0, 0)
            .spline(6, 0.026, 0.004, 0.05, 0.024, 0.064, 0.08, 0.066, 0.17, 0.061, 0.26, 0.05, 0.32)
            .arc(0.04, 0.32, 90, 6)
            .line(0, 0.33);
    return Lathe.solid(profile, 76).turnZ(-90).scale(1, 1, 0.92).move(-0.172, 0.285, 0);
  }

  private static TriangleMesh bowl() {
    ProfileCurve outside =
        ProfileCurve.of(0, 0.036, 0.045, 0.036, 0.05, 0.032, 0.055, 0.033, 0.05, 0.045)
            .spline(6, 0.076, 0.066, 0.09, 0.1, 0.094, 0.135, 0.0945, 0.158);
    ProfileCurve inside =
        ProfileCurve.from(0.0925, 0.158)
            .spline(6, 0.092, 0.135, 0.088, 0.1, 0.074, 0.068, 0.046, 0.047);
    return Lathe.solid(outside.then(rim()).then(inside).line(0, 0.043), 70).move(BOWL_X, 0, 0);
  }

  private static ProfileCurve rim() {
    return ProfileCurve.from(0.0962, 0.1585).arc(0.0945, 0.1602, 180, 6);
  }

  private static TriangleMesh bowlHandle() {
    Spine bow =
        Spine.smooth(
            6, 0, 0.142, 0.09, 0, 0.147, 0.118, 0, 0.125, 0.136, 0, 0.095, 0.122, 0, 0.084, 0.08);
    return Sweep.of(SimplePolygon.superellipse(0.011, 0.004, 2.5, 24), bow)
        .move(BOWL_X + 0.02, 0, 0);
  }

  /** Returns the whisk: six loops of wire below a short shaft. */
  private static TriangleMesh whisk() {
    Spine loop =
        Spine.smooth(
            5, -0.004, 0.182, 0, -0.024, 0.15, 0, -0.044, 0.098, 0, -0.03, 0.064, 0, 0, 0.055, 0,
            0.03, 0.064, 0, 0.044, 0.098, 0, 0.024, 0.15, 0, 0.004, 0.182, 0);
    TriangleMesh wire = Sweep.tube(loop, 0.0013, 8);
    TriangleMesh whisk =
        RoundSolidBuilder.roundedCylinder(0.009, 0.05, 0.003, 4, 32).move(0, 0.176, 0);
    for (int i = 0; i < 6; i++) {
      // Each loop passes a little below the one before.
      whisk = whisk.append(wire.move(0, -0.001 * i, 0).turnY(30 * i));
    }
    return whisk.move(BOWL_X, 0, 0);
  }

  /**
   * Returns the hub, open above, where it is inside the head, since version 2 has an odd polygon
   * count.
   */
  private static TriangleMesh hub() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0.203, 0.03, 0.203).arc(0.03, 0.209, 90, 6).line(0.036, 0.236);
    return Lathe.surface(profile, 64).move(BOWL_X, 0, 0);
  }

  /** Returns the lid of the socket in front. */
  private static TriangleMesh cap() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0, 0.034, 0, 0.034, 0.005).arc(0.031, 0.005, 90, 5).line(0.014, 0.008);
    return Lathe.solid(profile.spline(4, 0.012, 0.014, 0.006, 0.017, 0, 0.0175), 64)
        .turnZ(-90)
        .move(0.158, 0.285, 0);
  }

  private static TriangleMesh lever() {
    TriangleMesh rod = Sweep.tube(Spine.of(0, 0, 0, 0, 0, 0.03), 0.0035, 16);
    TriangleMesh knob = RoundSolidBuilder.sphere(0.009, 14, 24).move(0, 0, 0.034);
    return rod.append(knob).turnX(8).move(-0.07, 0.262, 0.048);
  }
}
