package org.selectiverenderer.apartment.building;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.plan.WallSide;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * The four walls of a room and the skirting along them.
 *
 * @param bare whether they are grids of rectangles, which radiosity subdivides evenly
 */
record RoomWalls(Room room, List<Opening> openings, boolean bare) {

  /** Returns the walls with their openings cut out. */
  TriangleMesh walls() {
    List<TriangleMesh> all = new ArrayList<>();
    for (WallSide side : WallSide.values()) {
      all.add(side.place(room, bare ? sheets(side) : wall(side)));
    }
    return TriangleMesh.of(all);
  }

  private TriangleMesh sheets(WallSide side) {
    List<Opening> all = openings.stream().filter(o -> o.side() == side).toList();
    return new WallGridMesh(left(side), right(side), Room.HEIGHT, room.thickness(side), all).mesh();
  }

  private TriangleMesh wall(WallSide side) {
    double thickness = room.thickness(side);
    double left = left(side);
    double right = right(side);
    // North and south walls extend over the ends of the others, so that corners are closed.
    double overLeft = side.alongX() ? room.thickness(leftOf(side)) : 0;
    double overRight = side.alongX() ? room.thickness(rightOf(side)) : 0;
    ProfileCurve line = ProfileCurve.from(left - overLeft, 0);
    for (Opening door : on(side, true)) {
      line =
          line.line(door.left(), 0)
              .line(door.left(), door.top())
              .line(door.right(), door.top())
              .line(door.right(), 0);
    }
    line =
        line.line(right + overRight, 0)
            .line(right + overRight, Room.HEIGHT)
            .line(left - overLeft, Room.HEIGHT);
    SimplePolygon[] windows =
        on(side, false).stream()
            .map(
                w ->
                    SimplePolygon.rectangle(w.width(), w.height())
                        .move((w.left() + w.right()) / 2, w.sill() + w.height() / 2))
            .toArray(SimplePolygon[]::new);
    return ExtrudedSolid.plain(thickness, line.closed(), windows).move(0, 0, -thickness);
  }

  /**
   * Returns the skirting boards with chamfered upper edges, from door to door, since the trim lies
   * in the openings.
   */
  TriangleMesh skirting() {
    SimplePolygon section = SimplePolygon.of(0, 0, 0.014, 0, 0.014, 0.06, 0.006, 0.07, 0, 0.07);
    List<TriangleMesh> all = new ArrayList<>();
    for (WallSide side : WallSide.values()) {
      double from = left(side);
      for (Opening door : on(side, true)) {
        all.add(side.place(room, board(section, from, door.left())));
        from = door.right();
      }
      all.add(side.place(room, board(section, from, right(side))));
    }
    return TriangleMesh.of(all);
  }

  /** Returns a board along the wall to the right; the section's x comes out of the wall. */
  private static TriangleMesh board(SimplePolygon section, double from, double to) {
    return Sweep.of(section, Spine.of(from, 0, 0, to, 0, 0));
  }

  private double left(WallSide side) {
    return Math.min(side.across(low(side)), side.across(high(side)));
  }

  private double right(WallSide side) {
    return Math.max(side.across(low(side)), side.across(high(side)));
  }

  private double low(WallSide side) {
    return side.alongX() ? room.west() : Room.NORTH;
  }

  private double high(WallSide side) {
    return side.alongX() ? room.east() : Room.SOUTH;
  }

  private static WallSide leftOf(WallSide side) {
    return WallSide.values()[(side.ordinal() + 3) % 4];
  }

  private static WallSide rightOf(WallSide side) {
    return WallSide.values()[(side.ordinal() + 1) % 4];
  }

  private List<Opening> on(WallSide side, boolean doors) {
    return openings.stream()
        .filter(o -> o.side() == side && o.isDoor() == doors)
        .sorted(Comparator.comparingDouble(Opening::left))
        .toList();
  }
}
