package org.selectiverenderer.apartment.office;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.TextGeometry;

/**
 * A wooden ruler of 30 cm with a line per millimetre; it lies with its bevelled edge to the back
 * (thesis Fig 71).
 */
final class Ruler {
  private static final double THICK = 0.004;

  private Ruler() {}

  static ParametricModel model() {
    SimplePolygon section =
        SimplePolygon.of(
            0, 0, 0.034, 0, 0.034, 0.0012, 0.024, THICK, 0.001, THICK, 0, THICK - 0.001);
    TriangleMesh body = ExtrudedSolid.plain(0.316, section).turnY(90);
    ModelMaterial wood = ModelMaterial.satin(ModelColour.of(0.86, 0.66, 0.3));
    return ParametricModel.of(
        "ruler",
        Part.of("body", wood, body.move(-0.158, 0, 0.017)),
        Part.of("lines", Materials.BLACK, lines()),
        Part.of("numbers", Materials.BLACK, numbers()));
  }

  /** Returns the scale on the bevel's slope, with longer lines for 5 and 10 millimetres. */
  private static TriangleMesh lines() {
    List<TriangleMesh> all = new ArrayList<>();
    for (int mm = 0; mm <= 300; mm++) {
      double length = mm % 10 == 0 ? 0.0095 : mm % 5 == 0 ? 0.0075 : 0.005;
      TriangleMesh line = MeshOrientation.flat(mm % 10 == 0 ? 0.0008 : 0.0004, length);
      all.add(
          line.move(mm / 1000.0 - 0.15, -length / 2, 0)
              .turnX(-90)
              .turnX(-15.64)
              .move(0, 0.00142, -0.0168));
    }
    return TriangleMesh.of(all);
  }

  private static TriangleMesh numbers() {
    TextGeometry letters = TextGeometry.bold();
    List<TriangleMesh> all = new ArrayList<>();
    for (int cm = 10; cm <= 20; cm += 10) {
      TriangleMesh number = letters.flat(Integer.toString(cm), 0.011).turnX(-90);
      all.add(number.move(cm / 100.0 - 0.15, THICK + 0.0002, -0.0005));
    }
    return TriangleMesh.of(all);
  }
}
