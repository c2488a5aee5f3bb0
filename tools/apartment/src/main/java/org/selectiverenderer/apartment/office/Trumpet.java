package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * A brass trumpet that stands on its bell, its valves to the right, 0.5 m high; one version. Nobody
 * expects it in an office (rated 1.1 of 6, thesis 5.1).
 */
final class Trumpet {
  /** The x of the bell's tube, beside which the mouthpiece's tube runs on the right. */
  private static final double RIGHT = 0.032;

  private static final double LEFT = -0.038;
  private static final double SIDE = 0.014;
  private static final double TUBE = 0.0065;

  private Trumpet() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        ParametricModel.of(
            "trumpet",
            Part.of("bell", Materials.BRASS, bell().move(RIGHT, 0, SIDE)).crease(60),
            Part.of("tubes", Materials.BRASS, bow(), slide()).crease(60),
            Part.of("valves", Materials.BRASS, valves(0.016, -0.05, 0.1)),
            Part.of(
                "pistons",
                Materials.CHROME,
                valves(0.005, 0.05, 0.035),
                valves(0.011, 0.083, 0.005)),
            Part.of("mouthpiece", Materials.CHROME, mouthpiece())));
  }

  private static TriangleMesh bell() {
    ProfileCurve profile =
        ProfileCurve.of(0.06, 0, 0.0615, 0.003, 0.048, 0.014, 0.034, 0.035, 0.024, 0.07)
            .line(0.016, 0.12)
            .line(0.0105, 0.2)
            .line(0.0075, 0.3);
    return Lathe.solid(profile, 16);
  }

  /** Returns the bow from the bell's tube around the upper bend down to the third valve. */
  private static TriangleMesh bow() {
    double middle = (RIGHT + LEFT) / 2;
    ProfileCurve path =
        ProfileCurve.from(RIGHT, 0.29).line(RIGHT, 0.37).arc(middle, 0.37, 180, 6).line(LEFT, 0.22);
    return Sweep.tube(Spine.of(path), TUBE, 6).move(0, 0, SIDE);
  }

  /**
   * Returns the leadpipe and tuning slide, from the mouthpiece down and around the lower bend up to
   * the first valve.
   */
  private static TriangleMesh slide() {
    double middle = (RIGHT + LEFT) / 2;
    ProfileCurve path =
        ProfileCurve.from(RIGHT, 0.46)
            .line(RIGHT, 0.13)
            .arc(middle, 0.13, -180, 6)
            .line(LEFT, 0.29);
    return Sweep.tube(Spine.of(path), TUBE, 6).move(0, 0, -SIDE);
  }

  /** Returns three cylinders that lie from left to right above each other. */
  private static TriangleMesh valves(double radius, double from, double length) {
    TriangleMesh valve = MeshOrientation.sideways(RoundSolidBuilder.cylinder(radius, length, 8));
    return MeshPatterns.row(valve.move(from, 0.215, 0), 3, 0, 0.036, 0);
  }

  private static TriangleMesh mouthpiece() {
    ProfileCurve profile =
        ProfileCurve.of(
            0.005, 0, 0.007, 0.05, 0.013, 0.065, 0.0135, 0.072, 0.012, 0.074, 0.003, 0.064);
    return Lathe.solid(profile, 8).move(RIGHT, 0.445, -SIDE);
  }
}
