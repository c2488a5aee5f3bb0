package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Copies;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/**
 * A bookcase of dark oak with ten bays, whose dimensions are in {@link Shelves} (thesis Fig 71).
 */
final class Bookcase {
  private static final double BACK = 0.01;

  private Bookcase() {}

  static ParametricModel model() {
    return ParametricModel.of(
        "bookcase",
        Part.of("walls", Looks.DARK_OAK, walls()),
        Part.of("boards", Looks.DARK_OAK, boards()),
        Part.of("back", Looks.OAK, back()));
  }

  private static TriangleMesh walls() {
    double height = Shelves.HEIGHT - 0.03;
    TriangleMesh side =
        Boxes.bevelled(Shelves.BOARD, height, Shelves.DEPTH - 0.01, 0.005, 2)
            .move((Shelves.WIDTH - Shelves.BOARD) / 2, 0, -0.005);
    TriangleMesh post =
        Boxes.bevelled(Shelves.BOARD, height - 0.07, Shelves.DEPTH - 0.03, 0.005, 1)
            .move(0, 0.07, -0.01);
    return TriangleMesh.of(side, side.mirrorX(), post);
  }

  private static TriangleMesh boards() {
    TriangleMesh top =
        Boxes.bevelled(Shelves.WIDTH, 0.034, Shelves.DEPTH, 0.008, 2)
            .move(0, Shelves.HEIGHT - 0.034, 0);
    TriangleMesh plinth = Boxes.plain(Shelves.WIDTH - 0.04, 0.08, 0.03).move(0, 0, 0.11);
    TriangleMesh shelf =
        Boxes.bevelled(Shelves.BAY + 0.004, Shelves.BOARD, Shelves.DEPTH - 0.03, 0.005, 1)
            .move(Shelves.leftBay(), Shelves.top(0) - Shelves.BOARD, -0.01);
    TriangleMesh left = Copies.row(shelf, Shelves.COUNT, 0, Shelves.CLEAR + Shelves.BOARD, 0);
    return TriangleMesh.of(top, plinth, left, left.mirrorX());
  }

  private static TriangleMesh back() {
    return Boxes.plain(Shelves.WIDTH - 0.02, Shelves.HEIGHT - 0.04, BACK)
        .move(0, 0.02, -Shelves.DEPTH / 2 + BACK / 2);
  }
}
