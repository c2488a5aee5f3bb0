package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/** Two trays for letters above each other, open at the front, 0.26 m wide; one version. */
final class LetterTray {
  private static final double WIDTH = 0.26;
  private static final double DEPTH = 0.34;
  private static final double STEP = 0.075;

  private LetterTray() {}

  static ParametricModel model() {
    TriangleMesh paper = BoxBuilder.plain(0.21, 0.012, 0.297).move(0, 0.003, 0);
    return ModelPlacement.centred(
        ParametricModel.of(
            "letterTray",
            Part.of("trays", Materials.CHARCOAL, tray(), tray().move(0, STEP, 0)),
            Part.of("posts", Materials.SILVER, posts()),
            Part.of("papers", Materials.PAPER, paper, paper.turnY(2).move(0, STEP, 0.006)),
            Part.of("letter", Materials.WHITE, letter()),
            Part.of("stamp", Materials.RED, stamp())));
  }

  private static TriangleMesh tray() {
    TriangleMesh side = BoxBuilder.plain(0.004, 0.045, DEPTH).move(WIDTH / 2 - 0.002, 0, 0);
    TriangleMesh back = BoxBuilder.plain(WIDTH - 0.008, 0.045, 0.004).move(0, 0, 0.002 - DEPTH / 2);
    TriangleMesh floor = BoxBuilder.plain(WIDTH - 0.008, 0.003, DEPTH - 0.004).move(0, 0, 0.002);
    return TriangleMesh.of(side, side.mirrorX(), back, floor);
  }

  private static TriangleMesh posts() {
    return MeshPatterns.corners(
        BoxBuilder.plain(0.008, STEP + 0.01, 0.012), WIDTH / 2, DEPTH / 2 - 0.03);
  }

  private static TriangleMesh letter() {
    return BoxBuilder.plain(0.18, 0.002, 0.11).turnY(-7).move(0.01, STEP + 0.015, 0.05);
  }

  private static TriangleMesh stamp() {
    return MeshOrientation.flat(0.02, 0.024)
        .turnX(-90)
        .move(0.075, 0.0026, -0.038)
        .turnY(-7)
        .move(0.01, STEP + 0.015, 0.05);
  }
}
