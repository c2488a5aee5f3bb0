package org.selectiverenderer.apartment.lounge;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/**
 * A shelf unit for a television and books, 2.6 m wide and 1.9 m high: a low board (its top is 0.48
 * m high, with 1.76 m between the sides), columns of shelves at both ends, a bridge above.
 */
final class Biblioteca {
  private static final double WIDTH = 2.6;
  private static final double HEIGHT = 1.9;
  private static final double DEPTH = 0.42;
  private static final double COLUMN = 0.42;
  private static final double BOARD = 0.03;
  private static final double TOP_OF_BOARD = 0.48;
  private static final double BRIDGE = 1.52;
  private static final double[] SHELVES = {0.83, 1.18, BRIDGE - BOARD};

  private Biblioteca() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        ParametricModel.of(
            "biblioteca",
            Part.of("boards", Materials.WALNUT, boards()),
            Part.of("backs", Materials.WALNUT, backs()),
            Part.of("doors", Materials.CREAM_LACQUER, doors()),
            Part.of("knobs", Materials.PALE_BRASS, knobs()).crease(60),
            books("tealBooks", ModelColour.of(0.12, 0.3, 0.33), 0),
            books("rustBooks", ModelColour.of(0.55, 0.24, 0.14), 1),
            books("ochreBooks", ModelColour.of(0.75, 0.58, 0.28), 2)));
  }

  private static TriangleMesh boards() {
    double inner = WIDTH / 2 - COLUMN;
    List<TriangleMesh> all = new ArrayList<>();
    all.add(
        MeshPatterns.bothSides(
            board(BOARD, HEIGHT, DEPTH - 0.02).move(WIDTH / 2 - BOARD / 2, 0, 0)));
    all.add(
        MeshPatterns.bothSides(
            board(BOARD, HEIGHT - TOP_OF_BOARD, DEPTH - 0.06)
                .move(inner + BOARD / 2, TOP_OF_BOARD, -0.02)));
    all.add(board(WIDTH + 0.02, BOARD, DEPTH).move(0, TOP_OF_BOARD - BOARD, 0));
    all.add(board(WIDTH + 0.03, BOARD, DEPTH + 0.01).move(0, HEIGHT - BOARD, 0));
    all.add(board(2 * inner, BOARD, DEPTH - 0.08).move(0, BRIDGE - BOARD, -0.03));
    all.add(board(WIDTH - 0.08, 0.08, DEPTH - 0.06).move(0, 0, -0.02));
    double middle = (WIDTH / 2 + inner) / 2;
    for (double y : SHELVES) {
      TriangleMesh shelf = board(COLUMN - 2 * BOARD, BOARD, DEPTH - 0.06);
      all.add(MeshPatterns.bothSides(shelf.move(middle, y, -0.02)));
    }
    return TriangleMesh.of(all);
  }

  private static TriangleMesh board(double width, double height, double depth) {
    return BoxBuilder.bevelled(width, height, depth, 0.003, 1);
  }

  private static TriangleMesh backs() {
    TriangleMesh column = BoxBuilder.plain(COLUMN - BOARD, HEIGHT - TOP_OF_BOARD - BOARD, 0.01);
    double z = 0.015 - DEPTH / 2;
    return MeshPatterns.bothSides(column.move((WIDTH - COLUMN) / 2, TOP_OF_BOARD, z))
        .append(
            BoxBuilder.plain(WIDTH - 2 * COLUMN, HEIGHT - BRIDGE - BOARD, 0.01).move(0, BRIDGE, z));
  }

  private static double doorX(int door) {
    return (door - 2) * 0.505;
  }

  /** Returns five framed doors, and the box behind them. */
  private static TriangleMesh doors() {
    List<TriangleMesh> all = new ArrayList<>();
    all.add(BoxBuilder.plain(WIDTH - 2 * BOARD, 0.37, DEPTH - 0.06).move(0, 0.08, -0.02));
    for (int door = 0; door < 5; door++) {
      SimplePolygon frame = SimplePolygon.rectangle(0.495, 0.352);
      TriangleMesh rails = ExtrudedSolid.plain(0.022, frame, frame.inset(0.055)).move(0, 0.176, 0);
      TriangleMesh panel = BoxBuilder.plain(0.39, 0.25, 0.012).move(0, 0.051, 0.006);
      all.add(rails.append(panel).move(doorX(door), 0.09, DEPTH / 2 - 0.04));
    }
    return TriangleMesh.of(all);
  }

  private static TriangleMesh knobs() {
    TriangleMesh knob = RoundSolidBuilder.sphere(0.014, 5, 8);
    List<TriangleMesh> all = new ArrayList<>();
    for (int door = 0; door < 5; door++) {
      double side = door < 2 ? 0.215 : -0.215;
      all.add(knob.move(doorX(door) + side, 0.3, DEPTH / 2 - 0.008));
    }
    return TriangleMesh.of(all);
  }

  /** Returns rows of books in the columns and on the bridge; every third book has this colour. */
  private static Part books(String name, ModelColour colour, int which) {
    double left = -WIDTH / 2 + BOARD + 0.012;
    double right = WIDTH / 2 - COLUMN + BOARD + 0.012;
    List<TriangleMesh> all = new ArrayList<>();
    row(all, left, TOP_OF_BOARD, 6, which);
    row(all, left, SHELVES[1] + BOARD, 5, which + 1);
    row(all, right, SHELVES[0] + BOARD, 6, which + 2);
    row(all, right, SHELVES[2] + BOARD, 5, which);
    row(all, -0.7, BRIDGE, 8, which + 1);
    return Part.of(name, ModelMaterial.satin(colour), TriangleMesh.of(all));
  }

  private static void row(List<TriangleMesh> all, double x, double y, int count, int which) {
    double at = x;
    for (int i = 0; i < count; i++) {
      double thick = 0.034 + 0.007 * (5 * i % 4);
      double high = 0.215 + 0.018 * (7 * i % 5);
      if ((i + which) % 3 == 0) {
        TriangleMesh book = BoxBuilder.bevelled(thick - 0.002, high, 0.17, 0.006, 1);
        all.add(book.move(at + thick / 2, y, 0.02 + 0.006 * (i % 3)));
      }
      at += thick;
    }
  }
}
