package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A whiteboard, 1.4 m by 0.9 m, with a sketch of boxes and arrows, and pens on its tray. */
final class Whiteboard {
  private static final double WIDTH = 1.4;
  private static final double HEIGHT = 0.9;
  private static final double FACE = 0.012;

  private Whiteboard() {}

  static ParametricModel model() {
    SimplePolygon section = SimplePolygon.rectangle(0.02, 0.03).move(0.01, 0);
    TriangleMesh rim =
        Sweep.of(section, Spine.of(SimplePolygon.rectangle(WIDTH - 0.03, HEIGHT - 0.03)));
    TriangleMesh tray = BoxBuilder.plain(0.5, 0.012, 0.07).move(0.2, -HEIGHT / 2 - 0.012, 0.035);
    TriangleMesh board =
        BoxBuilder.plain(WIDTH - 0.03, HEIGHT - 0.03, FACE).move(0, -HEIGHT / 2 + 0.015, FACE / 2);
    TriangleMesh pen =
        RoundSolidBuilder.cylinder(0.008, 0.12, 5).turnZ(90).move(0.2, -HEIGHT / 2 + 0.0065, 0.045);
    return ParametricModel.of(
        "whiteboard",
        Part.of("rim", Materials.SILVER, rim, tray),
        Part.of("board", Materials.WHITE, board),
        Part.of("redPen", Materials.RED, pen),
        Part.of("bluePen", Materials.BLUE, pen.move(0.17, 0, 0)),
        Part.of("blueInk", ink(0.12, 0.22, 0.55), boxes(), line(0.34, -0.06, 0.24, 0)),
        Part.of(
            "redInk",
            ink(0.7, 0.12, 0.1),
            line(-0.22, 0.16, 0.2, 0),
            line(0.2, 0.16, 0.24, 0),
            line(0.34, -0.16, 0.3, 0)));
  }

  private static TriangleMesh boxes() {
    TriangleMesh box =
        TriangleMesh.of(
            line(-0.45, 0.09, 0.22, 0),
            line(-0.45, 0.23, 0.22, 0),
            line(-0.56, 0.16, 0.14, 90),
            line(-0.34, 0.16, 0.14, 90));
    return MeshPatterns.row(box, 3, 0.44, 0, 0);
  }

  /** Returns a stroke centred on (x, y). */
  private static TriangleMesh line(double x, double y, double length, double degrees) {
    return ParametricSurface.field(length, 0.008, 1, 1, (u, v) -> 0)
        .turnX(90)
        .turnZ(degrees)
        .move(x, y, FACE + 0.001);
  }

  private static ModelMaterial ink(double red, double green, double blue) {
    return ModelMaterial.matt(ModelColour.of(red, green, blue));
  }
}
