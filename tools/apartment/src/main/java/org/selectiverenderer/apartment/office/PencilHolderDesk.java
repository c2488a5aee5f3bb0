package org.selectiverenderer.apartment.office;

import java.util.function.DoubleFunction;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/** A round cup with five pencils and two pens, 0.2 m high in all (thesis Fig 71). */
final class PencilHolderDesk {
  /** Length, angle about the cup and lean of each pencil. */
  private static final double[][] PENCILS = {
    {0.160, 20, 11}, {0.172, 95, 9}, {0.150, 165, 12}, {0.168, 235, 10}, {0.145, 300, 12}
  };

  private PencilHolderDesk() {}

  static ParametricModel model() {
    ProfileCurve cup =
        ProfileCurve.of(0.039, 0, 0.042, 0.003, 0.042, 0.094, 0.0435, 0.097)
            .line(0.0425, 0.1)
            .line(0.040, 0.1)
            .line(0.039, 0.094)
            .line(0.038, 0.006);
    return ModelPlacement.centred(
        ParametricModel.of(
            "pencilHolderDesk",
            Part.of("cup", Materials.CHARCOAL, Lathe.solid(cup, 20)),
            pencils("yellowPencils", 0.85, 0.62, 0.12, 0, 1, 3),
            pencils("redPencils", 0.7, 0.13, 0.1, 2, 4),
            each(
                "wood",
                ModelMaterial.matt(ModelColour.of(0.82, 0.66, 0.46)),
                WritingTools::sharpenedWood),
            each("leads", Materials.BLACK, WritingTools::lead),
            Part.of("pens", Materials.BLUE, pen(58), pen(200))));
  }

  private static TriangleMesh pen(double around) {
    return WritingTools.lean(WritingTools.pen(0.145, 8), 0.014, 7, around, 0.0075);
  }

  private static Part pencils(String name, double red, double green, double blue, int... which) {
    TriangleMesh all = TriangleMesh.EMPTY;
    for (int i : which) {
      all = all.append(stand(WritingTools.pencil(PENCILS[i][0]), PENCILS[i]));
    }
    return Part.of(name, ModelMaterial.satin(ModelColour.of(red, green, blue)), all).crease(20);
  }

  private static Part each(String name, ModelMaterial look, DoubleFunction<TriangleMesh> piece) {
    TriangleMesh all = TriangleMesh.EMPTY;
    for (double[] pencil : PENCILS) {
      all = all.append(stand(piece.apply(pencil[0]), pencil));
    }
    return Part.of(name, look, all);
  }

  private static TriangleMesh stand(TriangleMesh mesh, double[] pencil) {
    return WritingTools.lean(mesh, 0.012, pencil[2], pencil[1], 0.007);
  }
}
