package org.selectiverenderer.apartment.office;

import java.util.function.DoubleFunction;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.SimplePolygon;

/**
 * A square wooden box with pencils, pens and a pair of scissors, 0.21 m high in all (thesis Fig
 * 71).
 */
final class LibraryPencilHolder {
  /** Length, angle about the box and lean of each pencil. */
  private static final double[][] PENCILS = {
    {0.165, 40, 9}, {0.155, 130, 10}, {0.175, 215, 8}, {0.15, 320, 9}
  };

  private LibraryPencilHolder() {}

  static ParametricModel model() {
    TriangleMesh walls =
        ExtrudedSolid.plate(
            0.105,
            0.002,
            2,
            SimplePolygon.roundedRectangle(0.09, 0.09, 0.012, 4),
            SimplePolygon.roundedRectangle(0.078, 0.078, 0.006, 4));
    return ModelPlacement.centred(
        ParametricModel.of(
            "libraryPencilHolder",
            Part.of("box", Materials.DARK_OAK, walls, BoxBuilder.plain(0.082, 0.006, 0.082)),
            each("pencils", Materials.GREEN, WritingTools::pencil).crease(20),
            each(
                "wood",
                ModelMaterial.matt(ModelColour.of(0.82, 0.66, 0.46)),
                WritingTools::sharpenedWood),
            each("leads", Materials.BLACK, WritingTools::lead),
            Part.of("pens", Materials.BLUE, pen(5), pen(95)),
            Part.of("redPen", Materials.RED, pen(270)),
            Part.of("scissorsHandles", Materials.RED, loop(), loop().mirrorX()),
            Part.of("scissorsBlades", Materials.CHROME, blades())));
  }

  private static TriangleMesh pen(double around) {
    return WritingTools.lean(WritingTools.pen(0.145, 10), 0.018, 7, around, 0.0075);
  }

  private static TriangleMesh loop() {
    return WritingTools.scissorsLoop(3, 6).turnZ(-20).move(0.021, 0.165, 0);
  }

  private static TriangleMesh blades() {
    return BoxBuilder.plain(0.014, 0.13, 0.003).move(0, 0.007, 0);
  }

  private static Part each(String name, ModelMaterial look, DoubleFunction<TriangleMesh> piece) {
    TriangleMesh all = TriangleMesh.EMPTY;
    for (double[] pencil : PENCILS) {
      TriangleMesh mesh = piece.apply(pencil[0]);
      all = all.append(WritingTools.lean(mesh, 0.02, pencil[2], pencil[1], 0.0075));
    }
    return Part.of(name, look, all);
  }
}
