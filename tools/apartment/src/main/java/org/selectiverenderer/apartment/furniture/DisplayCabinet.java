package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** A cabinet, 1.1 m by 1.85 m: china on two shelves behind glass, and a cupboard below. */
final class DisplayCabinet {
  private static final double WIDTH = 1.1;
  private static final double HEIGHT = 1.85;
  private static final double DEPTH = 0.38;
  private static final double BOARD = 0.022;

  /** Height at which the cupboard ends and the glazed part begins, metres. */
  private static final double MIDDLE = 0.7;

  private static final double DOOR = WIDTH / 2 - 0.016;

  private DisplayCabinet() {}

  static ParametricModel model() {
    double glazed = HEIGHT - MIDDLE - 0.055;
    TriangleMesh frame =
        ExtrudedSolid.plain(
            0.02,
            SimplePolygon.rectangle(DOOR, glazed),
            SimplePolygon.rectangle(DOOR - 0.11, glazed - 0.11));
    TriangleMesh pane =
        ParametricSurface.field(DOOR - 0.1, glazed - 0.1, 1, 1, (x, z) -> 0)
            .turnX(90)
            .move(0, 0, 0.008);
    TriangleMesh door = BoxBuilder.plain(DOOR, MIDDLE - 0.1, 0.02).move(DOOR / 2 + 0.002, 0.085, 0);
    TriangleMesh knob = RoundSolidBuilder.sphere(0.015, 2, 5).turnX(90);
    double front = DEPTH / 2;
    double up = MIDDLE + 0.015 + glazed / 2;
    return ParametricModel.of(
        "displayCabinet",
        Part.of("carcass", Materials.DARK_WOOD, carcass()),
        Part.of(
            "doors",
            Materials.DARK_WOOD,
            MeshPatterns.bothSides(door.move(0, 0, front + 0.01)),
            MeshPatterns.bothSides(frame.move(DOOR / 2 + 0.002, up, front))),
        Part.of(
            "knobs",
            Materials.PALE_BRASS,
            MeshPatterns.bothSides(knob.move(0.03, MIDDLE - 0.1, front + 0.03)),
            MeshPatterns.bothSides(knob.move(0.03, MIDDLE + 0.4, front + 0.03))),
        Part.of("dishes", Materials.CHINA, dish().move(-0.24, MIDDLE + BOARD, -0.02)).crease(60),
        Part.of("bowls", Materials.BLUE_CHINA, dish().move(0.27, MIDDLE + 0.36 + BOARD, -0.02))
            .crease(60),
        Part.of(
            "panes",
            Materials.GLASS,
            MeshPatterns.bothSides(pane.move(DOOR / 2 + 0.002, up, front))));
  }

  private static TriangleMesh carcass() {
    TriangleMesh side =
        BoxBuilder.plain(BOARD, HEIGHT - 0.03, DEPTH).move((WIDTH - BOARD) / 2, 0, 0);
    TriangleMesh shelf =
        BoxBuilder.plain(WIDTH - 2 * BOARD, BOARD, DEPTH - 0.01).move(0, 0, -0.005);
    TriangleMesh top =
        BoxBuilder.plain(WIDTH + 0.04, 0.03, DEPTH + 0.04).move(0, HEIGHT - 0.03, 0.02);
    TriangleMesh plinth = BoxBuilder.plain(WIDTH - 0.03, 0.07, 0.02).move(0, 0, DEPTH / 2 - 0.03);
    TriangleMesh back =
        BoxBuilder.plain(WIDTH - 0.01, HEIGHT - 0.08, 0.01).move(0, 0.06, -DEPTH / 2 + 0.005);
    return TriangleMesh.of(
        MeshPatterns.bothSides(side),
        MeshPatterns.row(shelf.move(0, MIDDLE, 0), 2, 0, 0.36, 0),
        top,
        plinth,
        back);
  }

  private static TriangleMesh dish() {
    return Lathe.solid(ProfileCurve.of(0.05, 0, 0.13, 0.09, 0.123, 0.09, 0, 0.02), 9);
  }
}
