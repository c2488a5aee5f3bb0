package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
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
 * A bicycle's wheel of 0.66 m with 20 spokes, leaning back by 10 degrees for a wall behind it. One
 * of the objects that no kitchen is expected to have (thesis, Appendix B).
 */
final class BicycleWheel {
  private static final double RADIUS = 0.314;
  private static final int SPOKES = 20;

  private BicycleWheel() {}

  static ParametricModel model() {
    SimplePolygon rim = SimplePolygon.of(0.284, -0.009, 0.299, -0.011, 0.299, 0.011, 0.284, 0.009);
    ProfileCurve hub =
        ProfileCurve.of(0, -0.05, 0.008, -0.05, 0.008, -0.034, 0.024, -0.03, 0.012, -0.022);
    ProfileCurve half =
        hub.line(0.012, 0.022).line(0.024, 0.03).line(0.008, 0.034).line(0.008, 0.05);
    return ModelPlacement.centred(
        "bicycleWheel",
        Part.of(
                "tyre",
                Materials.SOFT_BLACK,
                leaning(RoundSolidBuilder.torus(RADIUS, 0.017, 32, 6)))
            .crease(70),
        Part.of(
            "rim",
            Materials.POLISHED_STEEL,
            leaning(Lathe.ring(rim, 32)),
            leaning(Lathe.solid(half.line(0, 0.05), 8)),
            leaning(spokes())));
  }

  /** Returns the spokes, from both flanges of the hub in turn, each a little off the radius. */
  private static TriangleMesh spokes() {
    TriangleMesh all = TriangleMesh.EMPTY;
    for (int i = 0; i < SPOKES; i++) {
      double side = i % 2 == 0 ? 0.028 : -0.028;
      double twist = i % 4 < 2 ? 50 : -50;
      Spine line =
          Spine.of(0.021 * DegreeMath.cos(twist), side, 0.021 * DegreeMath.sin(twist), 0.288, 0, 0);
      all = all.append(Sweep.tube(line, 0.0016, 3).turnY(360.0 * i / SPOKES));
    }
    return all;
  }

  private static TriangleMesh leaning(TriangleMesh lying) {
    return lying.turnX(90 - 10);
  }
}
