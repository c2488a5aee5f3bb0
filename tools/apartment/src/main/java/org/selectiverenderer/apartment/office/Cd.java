package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/**
 * A stack of three jewel cases, and an open one beside it with the disc in it: 0.31 m wide (thesis
 * Fig 71).
 */
final class Cd {
  private static final double CASE = 0.0104;

  private Cd() {}

  static ParametricModel model() {
    ModelMaterial rainbow =
        new ModelMaterial(
            ModelColour.of(0.5, 0.56, 0.6),
            ModelColour.of(0.9, 0.8, 0.95),
            0.6,
            0,
            ModelColour.grey(0));
    TriangleMesh label =
        MeshOrientation.flat(0.122, 0.116).turnX(-90).turnY(8).move(-0.077, 3 * CASE + 0.0004, 0);
    TriangleMesh title =
        MeshOrientation.flat(0.08, 0.02)
            .turnX(-90)
            .move(0, 0.0004, 0.03)
            .turnY(8)
            .move(-0.077, 3 * CASE + 0.0004, 0);
    return ModelPlacement.centred(
        ParametricModel.of(
            "cd",
            Part.of("blueCase", Materials.BLUE, stacked(0, -5)),
            Part.of(
                "redCase", ModelMaterial.satin(ModelColour.of(0.55, 0.13, 0.12)), stacked(1, 4)),
            Part.of("topCase", Materials.SILVER, stacked(2, 8)),
            Part.of("cover", ModelMaterial.glossy(ModelColour.of(0.82, 0.5, 0.16)), label),
            Part.of("title", Materials.PAPER, title),
            Part.of("tray", Materials.CHARCOAL, tray().move(0.085, 0, 0)),
            Part.of("disc", rainbow, disc().move(0.085, 0.0072, 0)),
            Part.of("discMiddle", Materials.CHROME, middle().move(0.085, 0.0072, 0))));
  }

  private static TriangleMesh stacked(int level, double degrees) {
    return BoxBuilder.bevelled(0.142, CASE, 0.125, 0.0018, 3)
        .turnY(degrees)
        .move(-0.077, level * CASE, 0);
  }

  /** Returns the lower half of a case: a plate with a round hollow for the disc. */
  private static TriangleMesh tray() {
    TriangleMesh floor = BoxBuilder.plain(0.136, 0.004, 0.119);
    TriangleMesh rim =
        ExtrudedSolid.plate(
            0.0078,
            0.0008,
            1,
            SimplePolygon.roundedRectangle(0.142, 0.127, 0.003, 2),
            SimplePolygon.circle(0.0612, 56));
    return rim.append(floor);
  }

  private static TriangleMesh disc() {
    SimplePolygon section =
        SimplePolygon.of(0.018, 0, 0.0594, 0, 0.06, 0.0006, 0.0594, 0.0012, 0.018, 0.0012);
    return Lathe.ring(section, 96);
  }

  /** Returns the clear ring of the disc, and the hub that holds it. */
  private static TriangleMesh middle() {
    SimplePolygon ring =
        SimplePolygon.of(0.0075, 0.0001, 0.0182, 0.0001, 0.0182, 0.0011, 0.0075, 0.0011);
    TriangleMesh hub =
        RoundSolidBuilder.roundedCylinder(0.0068, 0.004, 0.0015, 2, 32).move(0, -0.002, 0);
    return Lathe.ring(ring, 48).append(hub);
  }
}
