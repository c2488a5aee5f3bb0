package org.selectiverenderer.apartment.frame;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Sheet;

/** Floors and ceilings: flat rectangles side by side, in several colours. */
final class Floors {
  /** How far the floor goes on under the walls, to their middles. */
  private static final double UNDER = 0.06;

  /** So far that no crack shows. */
  private static final double TOUCH = 0.002;

  private Floors() {}

  /** A chequered floor: two meshes. */
  static List<TriangleMesh> tiles(Room room, int across, int along) {
    List<List<TriangleMesh>> colours = List.of(new ArrayList<>(), new ArrayList<>());
    double width = (room.east() - room.west() + 2 * UNDER) / across;
    double depth = (Room.SOUTH - Room.NORTH) / along;
    for (int i = 0; i < across; i++) {
      for (int j = 0; j < along; j++) {
        double x = room.west() - UNDER + i * width;
        double z = Room.NORTH + j * depth;
        colours.get((i + j) % 2).add(rectangle(x, z, x + width, z + depth));
      }
    }
    return colours.stream().map(TriangleMesh::of).toList();
  }

  /** Boards that run east and west with their ends staggered: three meshes, light to dark. */
  static List<TriangleMesh> boards(Room room, int rows, int perRow) {
    List<List<TriangleMesh>> colours =
        List.of(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
    double depth = (Room.SOUTH - Room.NORTH) / rows;
    double west = room.west() - UNDER;
    double width = room.east() + UNDER - west;
    int colour = 0;
    for (int r = 0; r < rows; r++) {
      double z = Room.NORTH + r * depth;
      double x = west;
      for (int i = 0; i <= perRow; i++) {
        // Ends of neighbouring rows are at other thirds; colours come from a small permutation.
        double to = west + width * Math.min(1, (i + (r * 2 % 3 + 1) / 3.0) / perRow);
        colour = (colour * 5 + 7 * r + 3 * i + 1) % 11;
        if (to - x > 1e-6) {
          colours.get(colour % 3).add(rectangle(x, z, to, z + depth));
        }
        x = to;
      }
    }
    return colours.stream().map(TriangleMesh::of).toList();
  }

  /**
   * The ceiling, which faces down.
   *
   * @param bare whether it just touches the walls: what reaches into them is never seen, and takes
   *     facets from where light is
   */
  static TriangleMesh ceiling(Room room, boolean bare) {
    double over = bare ? TOUCH : UNDER;
    return rectangle(room.west() - over, Room.NORTH - over, room.east() + over, Room.SOUTH + over)
        .move(0, Room.CEILING, 0)
        .flip();
  }

  static TriangleMesh rectangle(double west, double north, double east, double south) {
    return Sheet.field(east - west, south - north, 1, 1, (x, z) -> 0)
        .move((west + east) / 2, 0, (north + south) / 2);
  }
}
