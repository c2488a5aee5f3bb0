package org.selectiverenderer.modelling;

import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.geometry.mesh.TriangleMeshBuilder;

/**
 * Builds lofted surfaces over rows of points, joined row to row and point to point. A row of one
 * point, or whose points all coincide, is a pole.
 */
public final class LoftedSurface {
  /** The topology: how the points of a row, and the first and last row, are joined. */
  public enum Form {
    /** Rows are open, and so are both ends: {@code 2 (rows-1) (columns-1)} triangles. */
    SHEET,
    /** Each row is closed, both ends are open: {@code 2 (rows-1) columns} triangles. */
    PIPE,
    /** Each row is closed, and the last row joins the first: {@code 2 rows columns} triangles. */
    RING,
    /**
     * Each row is closed, and so is each end by a fan to its middle: {@code columns} triangles more
     * at each end.
     */
    CAPPED
  }

  private LoftedSurface() {}

  /**
   * @param rows the rows, with the same number of points except for poles; the points of a row run
   *     to the right if the next row is up, seen from outside. A closed surface is oriented
   *     outwards in any case.
   */
  public static TriangleMesh over(List<Vector3d[]> rows, Form form) {
    TriangleMeshBuilder mesh = new TriangleMeshBuilder();
    int columns = 1;
    for (Vector3d[] row : rows) {
      columns = Math.max(columns, row.length);
    }
    int[][] points = new int[rows.size()][];
    for (int r = 0; r < points.length; r++) {
      points[r] = row(mesh, rows.get(r), columns);
    }
    boolean around = form != Form.SHEET;
    for (int r = 0; r + 1 < points.length; r++) {
      band(mesh, points[r], points[r + 1], around);
    }
    if (form == Form.RING) {
      band(mesh, points[points.length - 1], points[0], true);
    }
    if (form == Form.CAPPED) {
      cap(mesh, rows.get(0), points[0], true);
      cap(mesh, rows.get(points.length - 1), points[points.length - 1], false);
    }
    TriangleMesh skin = mesh.mesh();
    return skin.isClosed() ? skin.outward() : skin;
  }

  private static int[] row(TriangleMeshBuilder mesh, Vector3d[] row, int columns) {
    int[] indices = new int[columns];
    boolean pole = isPole(row);
    if (!pole && row.length != columns) {
      throw new IllegalArgumentException(
          "each row needs the same number of points, or one point for a pole");
    }
    for (int c = 0; c < columns; c++) {
      indices[c] = pole && c > 0 ? indices[0] : mesh.point(row[pole ? 0 : c]);
    }
    return indices;
  }

  private static boolean isPole(Vector3d[] row) {
    for (Vector3d point : row) {
      if (point.distanceSquared(row[0]) > 1e-16) {
        return false;
      }
    }
    return true;
  }

  private static void band(TriangleMeshBuilder mesh, int[] lower, int[] upper, boolean around) {
    int columns = lower.length;
    for (int c = 0; c < (around ? columns : columns - 1); c++) {
      int next = (c + 1) % columns;
      if (lower[c] != lower[next]) {
        mesh.triangle(lower[c], lower[next], upper[next]);
      }
      if (upper[c] != upper[next]) {
        mesh.triangle(lower[c], upper[next], upper[c]);
      }
    }
  }

  private static void cap(TriangleMeshBuilder mesh, Vector3d[] row, int[] points, boolean first) {
    if (points.length < 3 || points[0] == points[1]) {
      return;
    }
    Vector3d middle = new Vector3d();
    for (Vector3d point : row) {
      middle.add(point);
    }
    int hub = mesh.point(middle.div(row.length));
    for (int c = 0; c < points.length; c++) {
      int next = points[(c + 1) % points.length];
      mesh.triangle(hub, first ? next : points[c], first ? points[c] : next);
    }
  }
}
