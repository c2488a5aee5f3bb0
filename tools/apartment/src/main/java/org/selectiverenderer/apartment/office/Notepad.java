package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/** A written-on notepad with a pencil across it, 0.15 m by 0.21 m; one version. */
final class Notepad {
  private static final double THICK = 0.01;

  private Notepad() {}

  static ParametricModel model() {
    TriangleMesh line =
        MeshOrientation.flat(0.11, 0.0025).turnX(-90).move(0, THICK + 0.0003, -0.06);
    return ModelPlacement.centred(
        ParametricModel.of(
            "notepad",
            Part.of(
                "paper",
                ModelMaterial.matt(ModelColour.of(0.95, 0.9, 0.66)),
                BoxBuilder.plain(0.15, THICK, 0.2)),
            Part.of(
                "binding",
                Materials.DARK_OAK,
                BoxBuilder.plain(0.151, THICK + 0.001, 0.016).move(0, 0, -0.1)),
            Part.of("writing", Materials.BLUE, MeshPatterns.row(line, 7, 0, 0, 0.016)),
            Part.of("pencil", Materials.RED, lying(WritingTools.pencil(0.13))).crease(20),
            Part.of(
                "wood",
                ModelMaterial.matt(ModelColour.of(0.82, 0.66, 0.46)),
                lying(WritingTools.sharpenedWood(0.13))),
            Part.of("lead", Materials.BLACK, lying(WritingTools.lead(0.13)))));
  }

  private static TriangleMesh lying(TriangleMesh tool) {
    return MeshOrientation.sideways(tool).move(-0.07, THICK + 0.0042, 0.03).turnY(35);
  }
}
