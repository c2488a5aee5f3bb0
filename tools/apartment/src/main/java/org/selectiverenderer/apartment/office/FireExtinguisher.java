package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
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
 * A red fire extinguisher on its wall bracket, 0.5 m high; its back plate is its rearmost part. The
 * lowest point is y = 0, so that it also stands (thesis Fig 71).
 */
final class FireExtinguisher {
  private static final double RADIUS = 0.075;

  private FireExtinguisher() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        ParametricModel.of(
            "fireExtinguisher",
            Part.of("bottle", Materials.RED, bottle()).crease(50),
            Part.of("label", Materials.PAPER, band(0.14, 0.27, 130)),
            Part.of("stripe", Materials.RED, band(0.2, 0.235, 118).scale(1.02, 1, 1.02)),
            Part.of("valve", Materials.BRASS, valve()),
            Part.of("levers", Materials.BLACK, lever(0), lever(16).move(0, 0.017, 0)),
            Part.of("gauge", Materials.WHITE, gauge()),
            Part.of("hose", Materials.RUBBER, hose(), horn()),
            Part.of("bracket", Materials.CHARCOAL, bracket())));
  }

  private static TriangleMesh bottle() {
    ProfileCurve profile =
        ProfileCurve.from(0, 0.012)
            .line(RADIUS - 0.012, 0.008)
            .line(RADIUS - 0.006, 0)
            .line(RADIUS - 0.002, 0)
            .line(RADIUS - 0.001, 0.014)
            .line(RADIUS, 0.022)
            .line(RADIUS, 0.335)
            .bezier(RADIUS, 0.375, 0.055, 0.395, 0.032, 0.402, 12)
            .bezier(0.022, 0.405, 0.02, 0.41, 0.02, 0.418, 5)
            .line(0, 0.418);
    return Lathe.solid(profile, 48);
  }

  /** Returns a label around the front of the bottle. */
  private static TriangleMesh band(double from, double to, double degrees) {
    double radius = RADIUS + 0.0015;
    return Lathe.sector(ProfileCurve.of(radius, from, radius, to), degrees, 18)
        .turnY(270 - degrees / 2);
  }

  private static TriangleMesh valve() {
    ProfileCurve profile =
        ProfileCurve.of(
            0.023, 0.416, 0.023, 0.424, 0.015, 0.427, 0.015, 0.452, 0.011, 0.452, 0.011, 0.475,
            0.008, 0.478);
    TriangleMesh outlet = MeshOrientation.sideways(RoundSolidBuilder.cylinder(0.008, 0.034, 16));
    return Lathe.solid(profile, 24).append(outlet.mirrorX().move(0, 0.44, 0));
  }

  /**
   * Returns a lever: a flat bar to the right, slightly bent down at its end, tilted up about the
   * valve.
   */
  private static TriangleMesh lever(double degrees) {
    SimplePolygon side =
        ProfileCurve.of(
                -0.012, 0, 0.05, 0, 0.095, -0.014, 0.097, -0.006, 0.052, 0.009, -0.012, 0.009)
            .closed()
            .rounded(0.004, 2);
    return ExtrudedSolid.bevelled(0.02, 0.001, 1, side).turnZ(degrees).move(0, 0.452, -0.01);
  }

  private static TriangleMesh gauge() {
    return MeshOrientation.forward(RoundSolidBuilder.roundedCylinder(0.013, 0.01, 0.003, 2, 20))
        .move(0, 0.439, 0.012);
  }

  /** Returns the hose from the valve over to the left and down beside the bottle. */
  private static TriangleMesh hose() {
    Spine path =
        Spine.smooth(
            5, -0.03, 0.44, 0, -0.06, 0.442, 0.005, -0.095, 0.415, 0.015, -0.104, 0.35, 0.02, -0.1,
            0.25, 0.02, -0.095, 0.15, 0.02);
    return Sweep.tube(path, 0.008, 10);
  }

  private static TriangleMesh horn() {
    ProfileCurve profile =
        ProfileCurve.of(0.022, 0, 0.023, 0.004, 0.011, 0.07, 0.0105, 0.085, 0.007, 0.09);
    return Lathe.solid(profile, 16).move(-0.095, 0.075, 0.02);
  }

  /** Returns the bracket: a plate at the wall, and the strap that holds the bottle to it. */
  private static TriangleMesh bracket() {
    TriangleMesh plate =
        ExtrudedSolid.bevelled(0.006, 0.002, 2, SimplePolygon.roundedRectangle(0.06, 0.32, 0.02, 4))
            .move(0, 0.24, -RADIUS - 0.012);
    SimplePolygon section =
        SimplePolygon.roundedRectangle(0.003, 0.022, 0.0014, 1).move(RADIUS + 0.001, 0);
    TriangleMesh spacer = BoxBuilder.plain(0.03, 0.03, 0.02).move(0, 0.3, -RADIUS);
    return TriangleMesh.of(plate, spacer, Lathe.ring(section, 36).move(0, 0.315, 0));
  }
}
