package org.selectiverenderer.apartment.building;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ParametricSurface;

/**
 * A wall meshed as a grid of rectangles between the lines on which its openings begin and end, so
 * that no rectangle has a corner on another's edge: radiosity can subdivide it without slivers,
 * which would show as fans of light. In the wall's coordinates: x to the right, y up, z out of the
 * wall.
 *
 * @param left x at which the front begins, metres; {@code right} is where it ends
 * @param openings doors and windows
 */
record WallGridMesh(
    double left, double right, double height, double thickness, List<Opening> openings) {
  /** Largest side of a rectangle of the front, metres. */
  private static final double LONGEST = 1.3;

  /**
   * Height at which the front begins, behind the skirting's upper edge, so that no rectangle is
   * half hidden.
   */
  private static final double FOOT = 0.06;

  /**
   * Distance that the strip hidden by the skirting stands back, so that it is not subdivided with
   * the front.
   */
  private static final double BACK = 0.002;

  /**
   * Returns the front, the back, and the reveals of the openings; the wall's ends lie in other
   * walls.
   */
  TriangleMesh mesh() {
    List<TriangleMesh> all = new ArrayList<>();
    List<Double> xs = lines(LONGEST, left, right, false);
    List<Double> ys = lines(LONGEST, FOOT, height, true);
    face(xs, ys, 0, all);
    foot(all);
    face(lines(height * 9, left, right, false), lines(height * 9, 0, height, true), -1, all);
    openings.forEach(opening -> sides(opening, xs, ys, all));
    return TriangleMesh.of(all);
  }

  /** Adds the front, or at the wall's thickness the back. */
  private void face(List<Double> xs, List<Double> ys, int depth, List<TriangleMesh> all) {
    double z = depth * thickness;
    for (int i = 0; i + 1 < xs.size(); i++) {
      for (int j = 0; j + 1 < ys.size(); j++) {
        double x = xs.get(i);
        double y = ys.get(j);
        double width = xs.get(i + 1) - x;
        double up = ys.get(j + 1) - y;
        if (!open(x + width / 2, y + up / 2)) {
          TriangleMesh front = rectangle(x, y, z, width, 0, up, 0);
          all.add(depth == 0 ? front : front.flip());
        }
      }
    }
  }

  private void foot(List<TriangleMesh> all) {
    List<Double> xs = lines(9 * height, left, right, false);
    for (int i = 0; i + 1 < xs.size(); i++) {
      double width = xs.get(i + 1) - xs.get(i);
      if (!open(xs.get(i) + width / 2, FOOT)) {
        all.add(rectangle(xs.get(i), 0, -BACK, width, 0, FOOT + 0.005, 0));
      }
    }
  }

  /**
   * Returns the grid lines: where openings begin and end, and lines between at most {@code longest}
   * apart.
   */
  private List<Double> lines(double longest, double from, double to, boolean up) {
    TreeSet<Double> at = new TreeSet<>(List.of(from, to));
    for (Opening opening : openings) {
      at.add(up ? Math.max(from, opening.sill()) : opening.left());
      at.add(up ? opening.top() : opening.right());
    }
    List<Double> all = new ArrayList<>();
    double last = from;
    for (double line : at) {
      int parts = (int) Math.ceil((line - last) / longest);
      for (int i = 1; i < parts; i++) {
        all.add(last + (line - last) * i / parts);
      }
      all.add(line);
      last = line;
    }
    return all;
  }

  private boolean open(double x, double y) {
    return openings.stream()
        .anyMatch(o -> x > o.left() && x < o.right() && y > o.sill() && y < o.top());
  }

  /**
   * Adds the reveals of an opening, divided as the front beside them is; a door has no lower one.
   */
  private void sides(Opening opening, List<Double> xs, List<Double> ys, List<TriangleMesh> all) {
    for (int j = 0; j + 1 < ys.size(); j++) {
      double y = j == 0 && opening.isDoor() ? 0 : ys.get(j);
      double up = ys.get(j + 1) - y;
      if (y + up / 2 > opening.sill() && y + up / 2 < opening.top()) {
        all.add(rectangle(opening.left(), y, 0, 0, -thickness, up, 0));
        all.add(rectangle(opening.right(), y, -thickness, 0, thickness, up, 0));
      }
    }
    for (int i = 0; i + 1 < xs.size(); i++) {
      double x = xs.get(i);
      double width = xs.get(i + 1) - x;
      if (x + width / 2 > opening.left() && x + width / 2 < opening.right()) {
        all.add(rectangle(x, opening.top(), -thickness, width, 0, 0, thickness));
        if (!opening.isDoor()) {
          all.add(rectangle(x, opening.sill(), 0, width, 0, 0, -thickness));
        }
      }
    }
  }

  /**
   * Returns a rectangle of two triangles from a corner along u and v; it faces the viewer for whom
   * u goes right and v goes up.
   */
  private static TriangleMesh rectangle(
      double x, double y, double z, double ux, double uz, double vy, double vz) {
    return ParametricSurface.of(
        1, 1, (u, v) -> new Vector3d(x + u * ux, y + v * vy, z + u * uz + v * vz));
  }
}
