package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** A steel toaster for two slices, empty, with its lever and dial at the right. */
final class Toaster {
  private static final double WIDTH = 0.29;
  private static final double DEPTH = 0.17;

  private Toaster() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        "toaster",
        Part.of("shell", Materials.POLISHED_STEEL, shell()),
        Part.of("trim", Materials.SOFT_BLACK, base(), slots(), lever(), dial()));
  }

  private static TriangleMesh shell() {
    SimplePolygon seenFromAbove = SimplePolygon.roundedRectangle(WIDTH, DEPTH, 0.05, 5);
    return RoundedSlabs.lying(seenFromAbove, 0.158, 0.024, 4).move(0, 0.014, 0);
  }

  private static TriangleMesh base() {
    SimplePolygon seenFromAbove =
        SimplePolygon.roundedRectangle(WIDTH + 0.004, DEPTH + 0.004, 0.05, 2);
    return ExtrudedSolid.plate(0.022, 0.006, 1, seenFromAbove);
  }

  /** Returns a raised frame around the two openings, which are dark: the shell has no inside. */
  private static TriangleMesh slots() {
    SimplePolygon slot = SimplePolygon.rectangle(0.176, 0.03).move(-0.012, 0);
    TriangleMesh dark = BoxBuilder.plain(0.18, 0.002, 0.034).move(-0.012, 0, 0);
    return ExtrudedSolid.plate(
            0.006,
            0.002,
            1,
            SimplePolygon.roundedRectangle(0.212, 0.118, 0.02, 2).move(-0.008, 0),
            slot.move(0, 0.033),
            slot.move(0, -0.033))
        .append(dark.move(0, 0.0005, 0.033))
        .append(dark.move(0, 0.0005, -0.033))
        .move(0, 0.1705, 0);
  }

  private static TriangleMesh lever() {
    return BoxBuilder.bevelled(0.03, 0.014, 0.034, 0.005, 1)
        .move(WIDTH / 2 + 0.014, 0.112, 0)
        .append(BoxBuilder.plain(0.004, 0.09, 0.01).move(WIDTH / 2, 0.045, 0));
  }

  private static TriangleMesh dial() {
    return RoundSolidBuilder.roundedCylinder(0.015, 0.014, 0.004, 1, 12)
        .turnZ(-90)
        .move(WIDTH / 2, 0.04, 0.042);
  }
}
