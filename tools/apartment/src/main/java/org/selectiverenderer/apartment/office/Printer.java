package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.TextGeometry;

/**
 * A desk printer, 0.4 m wide: paper stands in its back, a printed page lies in its mouth (thesis
 * Fig 71). Its lettering is an open surface.
 */
final class Printer {
  private static final double WIDTH = 0.4;
  private static final double FRONT = 0.1;
  private static final double LID = 0.15;

  private Printer() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        ParametricModel.of(
            "printer",
            Part.of("body", Materials.SILVER, body()),
            Part.of("lid", Materials.CHARCOAL, lid(), feeder()),
            Part.of("inside", Materials.RUBBER, inside()),
            Part.of("rollers", Materials.GREY, rollers()),
            Part.of("vents", Materials.RUBBER, vents(), vents().mirrorX()),
            Part.of("tray", Materials.CHARCOAL, tray()),
            Part.of("paper", Materials.PAPER, paper()),
            Part.of("print", Materials.GREY, print()),
            Part.of("panel", Materials.BLACK, panel()),
            Part.of("buttons", Materials.GREY, buttons()),
            Part.of("startButton", Materials.lit(0.2, 0.6, 0.25), button(0.0085).move(0.168, 0, 0)),
            Part.of("display", Materials.lit(0.35, 0.55, 0.7), display()),
            Part.of("brand", Materials.CHARCOAL, brand())));
  }

  /** Returns the body, open at the front where the pages come out. */
  private static TriangleMesh body() {
    return ExtrudedSolid.bevelled(
            0.235,
            0.01,
            7,
            SimplePolygon.roundedRectangle(WIDTH, LID, 0.022, 10),
            SimplePolygon.roundedRectangle(0.27, 0.052, 0.012, 8).move(0, -0.025))
        .move(0, LID / 2, FRONT - 0.235);
  }

  private static TriangleMesh lid() {
    return ExtrudedSolid.plate(
            0.026, 0.009, 6, SimplePolygon.roundedRectangle(0.392, 0.16, 0.02, 10))
        .move(0, LID - 0.004, FRONT - 0.115);
  }

  /** Returns the feeder that holds the stack of paper. */
  private static TriangleMesh feeder() {
    return BoxBuilder.bevelled(0.27, 0.15, 0.008, 0.003, 4).turnX(-10).move(0, LID - 0.02, -0.109);
  }

  private static TriangleMesh inside() {
    return BoxBuilder.plain(0.29, 0.075, 0.01).move(0, 0.012, FRONT - 0.06);
  }

  private static TriangleMesh rollers() {
    TriangleMesh roller =
        MeshOrientation.sideways(RoundSolidBuilder.roundedCylinder(0.009, 0.03, 0.003, 3, 32));
    return MeshPatterns.row(roller.move(-0.115, 0.06, FRONT - 0.035), 4, 0.068, 0, 0);
  }

  private static TriangleMesh vents() {
    TriangleMesh slot = BoxBuilder.bevelled(0.003, 0.05, 0.005, 0.0014, 3);
    return MeshPatterns.row(slot.move(WIDTH / 2, 0.05, -0.1), 10, 0, 0, 0.013);
  }

  private static TriangleMesh tray() {
    return ExtrudedSolid.plate(
            0.006, 0.0025, 4, SimplePolygon.roundedRectangle(0.25, 0.11, 0.016, 10))
        .turnX(-4)
        .move(0, 0.022, FRONT + 0.006);
  }

  /** Returns the paper: blank sheets behind, a page in front. */
  private static TriangleMesh paper() {
    TriangleMesh stack = BoxBuilder.plain(0.21, 0.2, 0.006).turnX(-10).move(0, LID - 0.02, -0.1);
    TriangleMesh page =
        ParametricSurface.thicken(
            ParametricSurface.field(
                0.21, 0.13, 20, 14, (x, z) -> 1.2 * z * z + 0.1 * Math.abs(x) * 0.3),
            0,
            -0.0008,
            0);
    return stack.append(page.move(0, 0.0305, FRONT + 0.01));
  }

  private static TriangleMesh print() {
    TriangleMesh line = MeshOrientation.flat(0.16, 0.0035).turnX(-90);
    return MeshPatterns.row(line.move(0, 0.0362, FRONT + 0.032), 4, 0, 0.0009, 0.0075);
  }

  /** Returns the control panel, which stands out on the right above the output slot. */
  private static TriangleMesh panel() {
    return ExtrudedSolid.bevelled(
            0.012, 0.004, 6, SimplePolygon.roundedRectangle(0.35, 0.038, 0.01, 10))
        .move(0, LID - 0.03, FRONT - 0.006);
  }

  private static TriangleMesh button(double radius) {
    return MeshOrientation.forward(RoundSolidBuilder.roundedCylinder(radius, 0.005, 0.002, 3, 28))
        .move(-0.012, LID - 0.03, FRONT + 0.004);
  }

  private static TriangleMesh buttons() {
    TriangleMesh small = button(0.0055).move(0.04, 0, 0);
    return MeshPatterns.row(small.move(0, 0.0085, 0), 6, 0.018, 0, 0)
        .append(MeshPatterns.row(small.move(0, -0.0085, 0), 6, 0.018, 0, 0));
  }

  private static TriangleMesh display() {
    return ExtrudedSolid.bevelled(
            0.003, 0.001, 3, SimplePolygon.roundedRectangle(0.075, 0.024, 0.003, 6))
        .move(-0.055, LID - 0.03, FRONT + 0.0045);
  }

  private static TriangleMesh brand() {
    return TextGeometry.bold().flat("PAGE 210", 0.0095).move(-0.163, 0.08, FRONT + 0.0005);
  }
}
