package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.SimplePolygon;

/** A tall cupboard, 0.66 m by 2.14 m, that goes on where the kitchen's worktop ends: four doors. */
final class Larder {
  private static final double WIDTH = 0.66;
  private static final double HEIGHT = 2.14;
  private static final double DEPTH = 0.56;
  private static final double PLINTH = 0.1;

  /** Height at which the lower doors end, in line with the hanging cupboards, metres. */
  private static final double MIDDLE = 1.42;

  private static final double FRONT = 0.02;

  private Larder() {}

  static ParametricModel model() {
    TriangleMesh doors =
        door(PLINTH, MIDDLE).append(door(MIDDLE, HEIGHT)).move(WIDTH / 4, 0, DEPTH / 2);
    TriangleMesh grip =
        BoxBuilder.plain(0.012, 0.18, 0.03).move(0.04, 0, DEPTH / 2 + FRONT + 0.015);
    return ParametricModel.of(
        "larder",
        Part.of(
            "carcass",
            ModelMaterial.satin(ModelColour.hex(0xD9D5CA)),
            BoxBuilder.plain(WIDTH, HEIGHT - PLINTH, DEPTH).move(0, PLINTH, 0)),
        Part.of(
            "plinth",
            Materials.SOFT_BLACK,
            BoxBuilder.plain(WIDTH, PLINTH, DEPTH - 0.06).move(0, 0, -0.03)),
        Part.of(
            "fronts",
            ModelMaterial.satin(ModelColour.hex(0x9FB0A2)),
            MeshPatterns.bothSides(doors)),
        Part.of(
            "grips",
            Materials.POLISHED_STEEL,
            MeshPatterns.bothSides(grip.move(0, 0.95, 0)),
            MeshPatterns.bothSides(grip.move(0, MIDDLE + 0.06, 0))));
  }

  /**
   * Returns a door from one height to another: a frame around a recessed panel, its back at z = 0.
   */
  private static TriangleMesh door(double from, double to) {
    SimplePolygon edge = SimplePolygon.rectangle(WIDTH / 2 - 0.004, to - from - 0.004);
    TriangleMesh frame = ExtrudedSolid.plain(FRONT, edge, edge.inset(0.06));
    return frame.append(ExtrudedSolid.plain(0.012, edge.inset(0.052))).move(0, (from + to) / 2, 0);
  }
}
