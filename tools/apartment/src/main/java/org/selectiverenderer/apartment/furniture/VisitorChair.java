package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A cantilever chair: two cushions on bent bars of steel, 0.84 m high. */
final class VisitorChair {
  private static final double SEAT = 0.44;
  private static final double TUBE = 0.012;

  private VisitorChair() {}

  static ParametricModel model() {
    TriangleMesh seat = BoxBuilder.bevelled(0.43, 0.05, 0.43, 0.02, 1).move(0, SEAT, 0.02);
    TriangleMesh back =
        BoxBuilder.bevelled(0.43, 0.3, 0.035, 0.015, 1).turnX(-8).move(0, SEAT + 0.1, -0.21);
    Spine side =
        Spine.of(
            0.225,
            TUBE,
            -0.2,
            0.225,
            TUBE,
            0.19,
            0.225,
            0.05,
            0.225,
            0.225,
            SEAT - 0.03,
            0.225,
            0.225,
            SEAT,
            0.18,
            0.225,
            SEAT + 0.01,
            -0.17,
            0.225,
            SEAT + 0.4,
            -0.255);
    TriangleMesh rail = BoxBuilder.plain(0.45, 2 * TUBE, 2 * TUBE).move(0, 0, -0.2);
    return ParametricModel.of(
        "visitorChair",
        Part.of("cushions", Materials.CHARCOAL, seat, back).crease(50),
        Part.of(
            "bars",
            Materials.CHROME,
            MeshPatterns.bothSides(Sweep.of(SimplePolygon.rectangle(0.026, 0.016), side)),
            rail));
  }
}
