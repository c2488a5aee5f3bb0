package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;

/** A loaf on a chopping board, with two slices cut from it and the knife in front. */
final class Bread {
  private static final double BOARD = 0.018;

  private Bread() {}

  static ParametricModel model() {
    TriangleMesh slice = ExtrudedSolid.bevelled(0.013, 0.003, 1, section());
    TriangleMesh cut = ExtrudedSolid.plain(0.001, section().inset(0.006));
    TriangleMesh leaning = ExtrudedSolid.plain(0.001, section().inset(0.006)).move(0, 0, 0.0127);
    return ModelPlacement.centred(
        "bread",
        Part.of("board", Materials.DARK_WOOD, board()),
        Part.of("crust", Materials.CRUST, loaf(), lying(slice, 0), lying(slice, 0.0135)),
        Part.of(
            "crumb",
            ModelMaterial.matt(ModelColour.hex(0xEAD7A8)),
            cut.turnY(90).move(0.03, BOARD, -0.035),
            lying(leaning, 0.0135)),
        Part.of("blade", Materials.POLISHED_STEEL, blade()),
        Part.of("handle", Materials.SOFT_BLACK, handle()));
  }

  /** Returns the section of the loaf, standing on y = 0. */
  private static SimplePolygon section() {
    return ProfileCurve.from(0.044, 0)
        .line(0.047, 0.045)
        .spline(2, 0.056, 0.066, 0.046, 0.084, 0.02, 0.093)
        .line(0, 0.094)
        .closedWithMirrorX();
  }

  private static TriangleMesh loaf() {
    return ExtrudedSolid.bevelled(0.17, 0.01, 1, section()).turnY(90).move(-0.1395, BOARD, -0.035);
  }

  /** Returns a slice laid flat on the board, face up, its base to the front. */
  private static TriangleMesh lying(TriangleMesh slice, double height) {
    double aside = 40 * height;
    return slice.turnX(-90).turnY(20 + 20 * aside).move(0.1 - 0.02 * aside, BOARD + height, 0.035);
  }

  private static TriangleMesh board() {
    SimplePolygon edge = SimplePolygon.roundedRectangle(0.4, 0.25, 0.03, 3);
    SimplePolygon hole = SimplePolygon.circle(0.013, 10).move(0.175, 0.09);
    return ExtrudedSolid.plate(BOARD, 0.004, 1, edge, hole);
  }

  private static TriangleMesh blade() {
    SimplePolygon side =
        SimplePolygon.of(0, 0, 0.14, 0.002, 0.172, 0.012, 0.185, 0.024, 0.15, 0.03, 0, 0.03);
    return ExtrudedSolid.plate(0.0016, 0, 0, side).move(-0.06, BOARD + 0.008, 0.098);
  }

  private static TriangleMesh handle() {
    SimplePolygon side = SimplePolygon.roundedRectangle(0.115, 0.026, 0.01, 2).move(-0.0575, 0.015);
    return ExtrudedSolid.plate(0.0176, 0.005, 1, side).move(-0.06, BOARD, 0.098);
  }
}
