package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;

/** A steel cabinet with four drawers for hanging files, 1.32 m high. */
final class FilingCabinet {
  private static final double WIDTH = 0.46;
  private static final double HEIGHT = 1.32;
  private static final double DEPTH = 0.58;
  private static final double STEP = 0.315;

  private FilingCabinet() {}

  static ParametricModel model() {
    double front = DEPTH / 2;
    TriangleMesh drawer = BoxBuilder.plain(WIDTH - 0.03, STEP - 0.014, 0.016).move(0, 0.04, front);
    TriangleMesh grip = BoxBuilder.plain(0.14, 0.018, 0.03).move(0, 0.23, front + 0.02);
    TriangleMesh label =
        ParametricSurface.field(0.075, 0.035, 1, 1, (x, z) -> 0)
            .turnX(90)
            .move(0, 0.29, front + 0.009);
    return ParametricModel.of(
        "filingCabinet",
        Part.of("body", Materials.GREY, BoxBuilder.bevelled(WIDTH, HEIGHT, DEPTH, 0.006, 1)),
        Part.of("drawers", Materials.SILVER, MeshPatterns.row(drawer, 4, 0, STEP, 0)),
        Part.of("grips", Materials.DARK_STEEL, MeshPatterns.row(grip, 4, 0, STEP, 0)),
        Part.of("labels", Materials.PAPER, MeshPatterns.row(label, 4, 0, STEP, 0)));
  }
}
