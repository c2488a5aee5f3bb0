package org.selectiverenderer.apartment.frame;

import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Outline;
import org.selectiverenderer.modelling.Sheet;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** The parts of a window with two casements in a wall opening. */
record RoomWindow(Room room, Opening opening) {
  private static final double BAR = 0.05;

  /** Returns the frame, the mullion, a casement's frame on each side, and the sill. */
  TriangleMesh frame() {
    double wing = opening.width() / 2 - BAR;
    TriangleMesh outer = bars(opening.width(), opening.height(), 0.07);
    TriangleMesh left = bars(wing + BAR, opening.height() - BAR, 0.05).move(-wing / 2, 0, 0.02);
    TriangleMesh sill =
        Boxes.plain(opening.width() + 0.16, 0.03, 0.26).move(0, -opening.height() / 2 - 0.03, 0.17);
    return placed(TriangleMesh.of(outer, left, left.mirrorX(), sill));
  }

  /** Returns a catch on the mullion. */
  TriangleMesh handle() {
    TriangleMesh lever = Boxes.plain(0.018, 0.12, 0.02).move(0, -0.1, 0.085);
    TriangleMesh plate = Boxes.plain(0.03, 0.07, 0.03).move(0, -0.04, 0.06);
    return placed(plate.append(lever));
  }

  TriangleMesh glass() {
    TriangleMesh pane =
        Sheet.field(opening.width() - BAR, opening.height() - BAR, 1, 1, (x, z) -> 0);
    return placed(pane.turnX(90).move(0, 0, 0.02));
  }

  private static TriangleMesh bars(double width, double height, double depth) {
    Outline section = Outline.rectangle(BAR, depth);
    return Sweep.of(section, Spine.of(Outline.rectangle(width - BAR, height - BAR)));
  }

  /**
   * Moves a mesh from coordinates about the middle of the opening, halfway into the wall, to the
   * room's coordinates.
   */
  private TriangleMesh placed(TriangleMesh mesh) {
    double x = (opening.left() + opening.right()) / 2;
    double y = opening.sill() + opening.height() / 2;
    return opening.side().place(room, mesh.move(x, y, -0.13));
  }
}
