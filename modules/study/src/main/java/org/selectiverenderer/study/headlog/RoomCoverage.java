package org.selectiverenderer.study.headlog;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.study.headlog.SceneMap.Box;

/**
 * The share of a room that a participant has seen. Floor, ceiling and the four walls of the room's
 * box are divided into cells; a cell counts as seen if its centre was within the field of view of
 * some visible sample taken inside the room. Occlusion is ignored, so the share is an upper bound.
 * The thesis excluded a participant who had not viewed the whole room (6.1.4).
 *
 * @param seconds time spent in the room
 * @param seen share of the cells that were seen, 0 to 1
 * @param unseen names of the sides of which less than 5 % was seen
 */
record RoomCoverage(String room, double seconds, double seen, List<String> unseen) {
  /** Cells along each edge of a side. */
  private static final int CELLS = 12;

  private static final double LITTLE = 0.05;
  private static final List<String> SIDES =
      List.of("wall -X", "wall +X", "floor", "ceiling", "wall -Z", "wall +Z");

  /** Computes the share of a room that a log has seen. */
  static RoomCoverage of(Box room, HeadLog log) {
    List<Vector3d> cells = cells(room.bounds());
    BitSet seen = new BitSet(cells.size());
    double seconds = 0;
    HeadLogMetadata shown = log.description();
    Vector3d local = new Vector3d();
    Quaterniond turn = new Quaterniond();
    for (int i = 0; i < log.samples().size(); i++) {
      HeadSample sample = log.samples().get(i);
      if (!sample.visible() || !room.contains(sample.x(), sample.y(), sample.z())) {
        continue;
      }
      seconds += log.shown(i);
      turn.rotationYXZ(
              Math.toRadians(sample.yaw()),
              Math.toRadians(sample.pitch()),
              Math.toRadians(sample.roll()))
          .conjugate();
      for (int cell = seen.nextClearBit(0);
          cell < cells.size();
          cell = seen.nextClearBit(cell + 1)) {
        turn.transform(cells.get(cell).sub(sample.x(), sample.y(), sample.z(), local));
        if (local.z < 0
            && Math.abs(local.x) <= -local.z * shown.tanX()
            && Math.abs(local.y) <= -local.z * shown.tanY()) {
          seen.set(cell);
        }
      }
    }
    int perSide = CELLS * CELLS;
    List<String> unseen = new ArrayList<>();
    for (int side = 0; side < SIDES.size(); side++) {
      int count = seen.get(side * perSide, (side + 1) * perSide).cardinality();
      if (count < LITTLE * perSide) {
        unseen.add(SIDES.get(side));
      }
    }
    return new RoomCoverage(
        room.name(), seconds, seen.cardinality() / (double) cells.size(), unseen);
  }

  /** Returns the centres of the cells, side by side in the order of {@link #SIDES}. */
  private static List<Vector3d> cells(double[] bounds) {
    List<Vector3d> cells = new ArrayList<>();
    for (int axis = 0; axis < 3; axis++) {
      int u = (axis + 1) % 3;
      int v = (axis + 2) % 3;
      for (int side = 0; side < 2; side++) {
        for (int i = 0; i < CELLS * CELLS; i++) {
          Vector3d cell = new Vector3d();
          cell.setComponent(axis, bounds[axis + 3 * side]);
          cell.setComponent(u, between(bounds, u, i % CELLS));
          cell.setComponent(v, between(bounds, v, i / CELLS));
          cells.add(cell);
        }
      }
    }
    return cells;
  }

  private static double between(double[] bounds, int axis, int cell) {
    return bounds[axis] + (cell + 0.5) / CELLS * (bounds[axis + 3] - bounds[axis]);
  }
}
