package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Copies;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Standing;

/** A written-on notepad with a pencil across it, 0.15 m by 0.21 m; one version. */
final class Notepad {
  private static final double THICK = 0.01;

  private Notepad() {}

  static ParametricModel model() {
    TriangleMesh line = Placing.flat(0.11, 0.0025).turnX(-90).move(0, THICK + 0.0003, -0.06);
    return Standing.centred(
        ParametricModel.of(
            "notepad",
            Part.of(
                "paper", Look.matt(ModelColour.of(0.95, 0.9, 0.66)), Boxes.plain(0.15, THICK, 0.2)),
            Part.of(
                "binding",
                Looks.DARK_OAK,
                Boxes.plain(0.151, THICK + 0.001, 0.016).move(0, 0, -0.1)),
            Part.of("writing", Looks.BLUE, Copies.row(line, 7, 0, 0, 0.016)),
            Part.of("pencil", Looks.RED, lying(WritingTools.pencil(0.13))).crease(20),
            Part.of(
                "wood",
                Look.matt(ModelColour.of(0.82, 0.66, 0.46)),
                lying(WritingTools.sharpenedWood(0.13))),
            Part.of("lead", Looks.BLACK, lying(WritingTools.lead(0.13)))));
  }

  private static TriangleMesh lying(TriangleMesh tool) {
    return Placing.sideways(tool).move(-0.07, THICK + 0.0042, 0.03).turnY(35);
  }
}
