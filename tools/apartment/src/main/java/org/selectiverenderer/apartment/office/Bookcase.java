package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/**
 * A bookcase of dark oak with ten bays, whose dimensions are in {@link BookcaseDimensions} (thesis
 * Fig 71).
 */
final class Bookcase {
  private static final double BACK = 0.01;

  private Bookcase() {}

  static ParametricModel model() {
    return ParametricModel.of(
        "bookcase",
        Part.of("walls", Materials.DARK_OAK, walls()),
        Part.of("boards", Materials.DARK_OAK, boards()),
        Part.of("back", Materials.OAK, back()));
  }

  private static TriangleMesh walls() {
    double height = BookcaseDimensions.HEIGHT - 0.03;
    TriangleMesh side =
        BoxBuilder.bevelled(
                BookcaseDimensions.BOARD, height, BookcaseDimensions.DEPTH - 0.01, 0.005, 2)
            .move((BookcaseDimensions.WIDTH - BookcaseDimensions.BOARD) / 2, 0, -0.005);
    TriangleMesh post =
        BoxBuilder.bevelled(
                BookcaseDimensions.BOARD, height - 0.07, BookcaseDimensions.DEPTH - 0.03, 0.005, 1)
            .move(0, 0.07, -0.01);
    return TriangleMesh.of(side, side.mirrorX(), post);
  }

  private static TriangleMesh boards() {
    TriangleMesh top =
        BoxBuilder.bevelled(BookcaseDimensions.WIDTH, 0.034, BookcaseDimensions.DEPTH, 0.008, 2)
            .move(0, BookcaseDimensions.HEIGHT - 0.034, 0);
    TriangleMesh plinth =
        BoxBuilder.plain(BookcaseDimensions.WIDTH - 0.04, 0.08, 0.03).move(0, 0, 0.11);
    TriangleMesh shelf =
        BoxBuilder.bevelled(
                BookcaseDimensions.BAY + 0.004,
                BookcaseDimensions.BOARD,
                BookcaseDimensions.DEPTH - 0.03,
                0.005,
                1)
            .move(
                BookcaseDimensions.leftBay(),
                BookcaseDimensions.top(0) - BookcaseDimensions.BOARD,
                -0.01);
    TriangleMesh left =
        MeshPatterns.row(
            shelf,
            BookcaseDimensions.COUNT,
            0,
            BookcaseDimensions.CLEAR + BookcaseDimensions.BOARD,
            0);
    return TriangleMesh.of(top, plinth, left, left.mirrorX());
  }

  private static TriangleMesh back() {
    return BoxBuilder.plain(BookcaseDimensions.WIDTH - 0.02, BookcaseDimensions.HEIGHT - 0.04, BACK)
        .move(0, 0.02, -BookcaseDimensions.DEPTH / 2 + BACK / 2);
  }
}
