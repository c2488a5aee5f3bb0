package org.selectiverenderer.scenes;

import java.util.ArrayList;
import java.util.List;

/**
 * A surface of revolution about +Y: a profile turned round in equal steps.
 *
 * <p>The profile runs so that the outside lies to its right when radius points right and height
 * points up: up the outer wall, over the rim, down the inner wall. Every pair of neighbouring
 * profile points makes a band of {@code 2 * segments} triangles.
 *
 * @param segments steps of one turn
 * @param profile radius and height of each ring, in metres
 * @param bottom closes the start of the profile
 * @param inside closes the end of the profile
 */
record Lathe(int segments, List<Ring> profile, Cap bottom, Cap inside) {

  /** A circle about the axis. */
  record Ring(double radius, double height) {}

  /** How an end of the profile is closed. */
  enum Cap {
    /** Left open: no triangles. */
    NONE,
    /** A point on the axis: {@code segments} triangles. */
    CENTRE,
    /** Triangles between the ring's own points: {@code segments - 2} of them. */
    CHORDS
  }

  TriangleMesh mesh() {
    List<double[]> points = new ArrayList<>();
    List<int[]> triangles = new ArrayList<>();
    for (Ring ring : profile) {
      for (int s = 0; s < segments; s++) {
        double angle = 2 * Math.PI * s / segments;
        points.add(
            new double[] {
              ring.radius * Math.cos(angle), ring.height, -ring.radius * Math.sin(angle)
            });
      }
    }
    cap(bottom, 0, true, points, triangles);
    for (int ring = 0; ring + 1 < profile.size(); ring++) {
      band(ring, triangles);
    }
    cap(inside, profile.size() - 1, false, points, triangles);
    return new TriangleMesh(points, triangles);
  }

  private void band(int ring, List<int[]> triangles) {
    int lower = ring * segments;
    int upper = lower + segments;
    for (int s = 0; s < segments; s++) {
      int next = (s + 1) % segments;
      triangles.add(new int[] {lower + s, lower + next, upper + next});
      triangles.add(new int[] {lower + s, upper + next, upper + s});
    }
  }

  /** A ring's points run counter-clockwise seen from above, so a cap seen from below turns them. */
  private void cap(
      Cap cap, int ring, boolean fromBelow, List<double[]> points, List<int[]> triangles) {
    int first = ring * segments;
    int hub = cap == Cap.CENTRE ? points.size() : first;
    if (cap == Cap.CENTRE) {
      points.add(new double[] {0, profile.get(ring).height, 0});
    }
    int from = cap == Cap.CENTRE ? 0 : 1;
    int to = cap == Cap.NONE ? from : cap == Cap.CENTRE ? segments : segments - 1;
    for (int s = from; s < to; s++) {
      int a = first + s;
      int b = first + (s + 1) % segments;
      triangles.add(fromBelow ? new int[] {hub, b, a} : new int[] {hub, a, b});
    }
  }
}
