package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Copies;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Sheet;

/** A steel cabinet with four drawers for hanging files, 1.32 m high. */
final class FilingCabinet {
  private static final double WIDTH = 0.46;
  private static final double HEIGHT = 1.32;
  private static final double DEPTH = 0.58;
  private static final double STEP = 0.315;

  private FilingCabinet() {}

  static ParametricModel model() {
    double front = DEPTH / 2;
    TriangleMesh drawer = Boxes.plain(WIDTH - 0.03, STEP - 0.014, 0.016).move(0, 0.04, front);
    TriangleMesh grip = Boxes.plain(0.14, 0.018, 0.03).move(0, 0.23, front + 0.02);
    TriangleMesh label =
        Sheet.field(0.075, 0.035, 1, 1, (x, z) -> 0).turnX(90).move(0, 0.29, front + 0.009);
    return ParametricModel.of(
        "filingCabinet",
        Part.of("body", Looks.GREY, Boxes.bevelled(WIDTH, HEIGHT, DEPTH, 0.006, 1)),
        Part.of("drawers", Looks.SILVER, Copies.row(drawer, 4, 0, STEP, 0)),
        Part.of("grips", Looks.DARK_STEEL, Copies.row(grip, 4, 0, STEP, 0)),
        Part.of("labels", Looks.PAPER, Copies.row(label, 4, 0, STEP, 0)));
  }
}
