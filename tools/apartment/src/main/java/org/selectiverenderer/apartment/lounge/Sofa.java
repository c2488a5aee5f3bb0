package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** A sofa with two seats, rolled arms and loose cushions. The seats are 0.47 m high. */
final class Sofa {
  private static final double DEPTH = 0.9;
  private static final double ARM = 0.2;

  private Sofa() {}

  static ParametricModel first() {
    return model("sofa1", 2.1);
  }

  static ParametricModel second() {
    return model("sofa2", 1.75);
  }

  private static ParametricModel model(String name, double width) {
    double seat = (width - 2 * ARM) / 2;
    TriangleMesh base =
        BoxBuilder.bevelled(width - 0.1, 0.2, DEPTH - 0.06, 0.03, 2).move(0, 0.09, 0);
    TriangleMesh back = back(width - 2 * ARM + 0.06).move(0, 0.12, -DEPTH / 2);
    TriangleMesh arms = MeshPatterns.bothSides(arm().move(width / 2 - ARM / 2, 0.1, -DEPTH / 2));
    return ModelPlacement.centred(
        ParametricModel.of(
            name,
            Part.of("frame", Materials.LINEN, base, back, arms),
            Part.of("seats", Materials.LINEN, MeshPatterns.bothSides(seatCushion(seat))).crease(60),
            Part.of("backs", Materials.LINEN, MeshPatterns.bothSides(backCushion(seat))).crease(60),
            Part.of(
                "feet", Materials.WALNUT, MeshPatterns.corners(foot(), width / 2 - 0.13, 0.34))));
  }

  private static TriangleMesh back(double width) {
    SimplePolygon side = ProfileCurve.of(0, 0, 0.26, 0, 0.26, 0.3, 0.2, 0.7, 0.03, 0.72).closed();
    return ExtrudedSolid.bevelled(width, 0.03, 2, side.rounded(0.07, 4))
        .move(0, 0, -width / 2)
        .turnY(-90);
  }

  /** Returns an arm: a roll on an upright board, extruded from back to front. */
  private static TriangleMesh arm() {
    SimplePolygon front =
        ProfileCurve.from(-0.085, 0)
            .line(0.075, 0)
            .line(0.08, 0.34)
            .arc(0.01, 0.42, 250, 14)
            .line(-0.085, 0.34)
            .closed();
    return ExtrudedSolid.bevelled(DEPTH, 0.02, 3, front);
  }

  private static TriangleMesh seatCushion(double width) {
    return RoundSolidBuilder.superellipsoid(width / 2 + 0.004, 0.095, 0.335, 3.2, 7, 18, 36)
        .deform(p -> p.add(0, p.y > 0 ? 0.022 * crown(p.x / width, p.z / 0.67) : 0, 0))
        .move(width / 2, 0.355, 0.105);
  }

  private static TriangleMesh backCushion(double width) {
    return RoundSolidBuilder.superellipsoid(width / 2 - 0.002, 0.1, 0.235, 2.7, 5, 18, 36)
        .deform(p -> p.add(0, p.y > 0 ? 0.03 * crown(p.x / width, p.z / 0.47) : 0, 0))
        .turnX(76)
        .move(width / 2, 0.66, -0.15);
  }

  /** Returns the fullness of a cushion, 1 in its middle, 0 at half a width from it. */
  private static double crown(double x, double z) {
    return Math.max(0, (1 - 4 * x * x) * (1 - 4 * z * z));
  }

  private static TriangleMesh foot() {
    return Lathe.solid(ProfileCurve.of(0.016, 0, 0.022, 0.01, 0.032, 0.08, 0.032, 0.1), 12);
  }
}
