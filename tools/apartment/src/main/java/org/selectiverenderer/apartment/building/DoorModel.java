package org.selectiverenderer.apartment.building;

import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * The parts of a door in a wall opening: trim, leaf and handle, in the wall's coordinates until
 * placed.
 */
record DoorModel(Room room, Opening opening) {
  /** Width of the trim, inwards from the opening's edge. */
  private static final double TRIM = 0.07;

  private static final double LEAF = 0.04;

  /** Returns the trim around the opening, with a chamfered edge. */
  TriangleMesh trim() {
    SimplePolygon section =
        SimplePolygon.of(0, 0, TRIM, 0, TRIM, 0.012, TRIM - 0.008, 0.02, 0, 0.02);
    double l = opening.left();
    double r = opening.right();
    double t = opening.top();
    Spine around = Spine.of(l, 0, 0, l, t, 0, r, t, 0, r, 0, 0);
    // On a spine that goes up, sections start with y towards -z, hence the mirrored y.
    return placed(Sweep.of(section.scale(-1, -1), around));
  }

  /** Returns a panelled leaf, shut. */
  TriangleMesh shutLeaf() {
    return placed(leaf().move(opening.left() + 0.01, 0, -LEAF - 0.02));
  }

  /** Returns the handle of a shut leaf. */
  TriangleMesh shutHandle() {
    return placed(handle().move(opening.left() + 0.01, 0, -0.02));
  }

  /** Returns the leaf opened into the room about its hinges at the left or right end. */
  TriangleMesh openLeaf(boolean hingesLeft, double degrees) {
    return opened(leaf().move(0.01, 0, -LEAF), hingesLeft, degrees);
  }

  TriangleMesh openHandle(boolean hingesLeft, double degrees) {
    TriangleMesh front = handle();
    TriangleMesh back = front.scale(1, 1, -1).move(0, 0, -LEAF);
    return opened(front.append(back).move(0.01, 0, 0), hingesLeft, degrees);
  }

  private TriangleMesh opened(TriangleMesh leaf, boolean hingesLeft, double degrees) {
    TriangleMesh turned =
        hingesLeft
            ? leaf.turnY(-degrees).move(opening.left(), 0, 0.005)
            : leaf.mirrorX().turnY(degrees).move(opening.right(), 0, 0.005);
    return placed(turned);
  }

  /**
   * Returns the leaf from x = 0 to the right with its front at z = LEAF; three panels stand out at
   * front and back.
   */
  private TriangleMesh leaf() {
    double width = opening.width() - 0.02;
    double height = opening.height() - 0.02;
    TriangleMesh board =
        BoxBuilder.bevelled(width, height, LEAF, 0.004, 1).move(width / 2, 0.008, LEAF / 2);
    TriangleMesh low = panel(width - 0.24, 0.55).move(width / 2, 0.2, LEAF / 2);
    TriangleMesh high = panel(width - 0.24, 1.0).move(width / 2, 0.88, LEAF / 2);
    return TriangleMesh.of(board, low, high);
  }

  private static TriangleMesh panel(double width, double height) {
    return BoxBuilder.bevelled(width, height, LEAF + 0.012, 0.012, 1);
  }

  /** Returns a lever on a round plate, from z = 0 outwards, at the end far from the hinges. */
  private TriangleMesh handle() {
    double x = opening.width() - 0.09;
    TriangleMesh plate = RoundSolidBuilder.cylinder(0.025, 0.03, 8).turnX(90);
    TriangleMesh lever =
        BoxBuilder.bevelled(0.13, 0.018, 0.014, 0.005, 1).move(-0.055, -0.009, 0.035);
    return plate.append(lever).move(x, 1.02, 0);
  }

  private TriangleMesh placed(TriangleMesh mesh) {
    return opening.side().place(room, mesh);
  }
}
