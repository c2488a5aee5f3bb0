package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/** A bench of oak without a back, 1.2 m long: a seat of three boards on two trestles. */
final class Bench {
  private static final double LENGTH = 1.2;
  private static final double SEAT = 0.45;
  private static final double BOARD = 0.03;
  private static final double LEG = SEAT - BOARD;

  private Bench() {}

  static ParametricModel model() {
    TriangleMesh board = BoxBuilder.bevelled(LENGTH, BOARD, 0.096, 0.004, 1).move(0, LEG, -0.102);
    TriangleMesh leg = BoxBuilder.plain(0.045, LEG, 0.045);
    TriangleMesh rail = BoxBuilder.plain(0.03, 0.06, 0.21).move(LENGTH / 2 - 0.12, LEG - 0.06, 0);
    TriangleMesh bar = BoxBuilder.plain(LENGTH - 0.27, 0.04, 0.025).move(0, 0.14, 0);
    TriangleMesh rung = BoxBuilder.plain(0.03, 0.04, 0.21).move(LENGTH / 2 - 0.12, 0.14, 0);
    return ParametricModel.of(
        "bench",
        Part.of("seat", Materials.LIGHT_OAK, MeshPatterns.row(board, 3, 0, 0, 0.102)),
        Part.of(
            "trestles",
            Materials.OAK,
            MeshPatterns.corners(leg, LENGTH / 2 - 0.12, 0.11),
            MeshPatterns.bothSides(rail),
            MeshPatterns.bothSides(rung),
            bar));
  }
}
