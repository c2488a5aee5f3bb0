package org.selectiverenderer.validation.geometry;

import java.util.Arrays;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.ParsedNode;

/** Faces without area, and edges of more than two faces. */
final class FaceCheck implements NodeCheck {
  /** The sine of the angle below which the points of a face lie on a line. */
  private static final double STRAIGHT = 1e-7;

  @Override
  public void check(ParsedNode node, GeometryFindings findings) {
    boolean separated = node.type().name().equals("IndexedFaceSet");
    if (!separated && !node.type().name().equals("IndexedTriangleSet")) {
      return;
    }
    NodeView coordinates = node.node("coord");
    if (coordinates != null && coordinates.type().name().equals("Coordinate")) {
      String field = separated ? "coordIndex" : "index";
      new Faces(node.ints(field), coordinates.floats("point"), separated)
          .report(node, field, findings);
    }
  }

  /** The faces of one node. */
  private static final class Faces {
    private final int[] indices;
    private final float[] points;
    private final boolean separated;
    private final long[] edges;
    private int edgeCount;
    private int faces;
    private int flat;
    private int firstFlat;

    Faces(int[] indices, float[] points, boolean separated) {
      this.indices = indices;
      this.points = points;
      this.separated = separated;
      this.edges = new long[indices.length];
    }

    void report(ParsedNode node, String field, GeometryFindings findings) {
      int from = 0;
      for (int i = 0; i <= indices.length; i++) {
        boolean ends = separated ? i == indices.length || indices[i] < 0 : i - from == 3;
        if (ends) {
          face(from, i);
          from = separated ? i + 1 : i;
        }
      }
      if (flat > 0) {
        findings.addAt(GeometryRules.NO_AREA, node, field, flat, faces, firstFlat);
      }
      crowded(node, field, findings);
    }

    private void face(int from, int to) {
      if (to - from < 3 || !known(from, to)) {
        return;
      }
      if (!hasArea(from, to)) {
        firstFlat = flat++ == 0 ? faces : firstFlat;
      } else {
        for (int i = from; i < to; i++) {
          edge(indices[i], indices[i + 1 == to ? from : i + 1]);
        }
      }
      faces++;
    }

    private boolean known(int from, int to) {
      for (int i = from; i < to; i++) {
        if (indices[i] < 0 || 3 * (long) indices[i] + 2 >= points.length) {
          return false;
        }
      }
      return true;
    }

    private void edge(int a, int b) {
      if (a != b) {
        edges[edgeCount++] = (long) Math.min(a, b) << 32 | Math.max(a, b);
      }
    }

    /** Newell's method, against the longest way from the first point. */
    private boolean hasArea(int from, int to) {
      int origin = 3 * indices[from];
      double nx = 0;
      double ny = 0;
      double nz = 0;
      double longest = 0;
      double ux = 0;
      double uy = 0;
      double uz = 0;
      for (int i = from + 1; i < to; i++) {
        int at = 3 * indices[i];
        double vx = (double) points[at] - points[origin];
        double vy = (double) points[at + 1] - points[origin + 1];
        double vz = (double) points[at + 2] - points[origin + 2];
        nx += uy * vz - uz * vy;
        ny += uz * vx - ux * vz;
        nz += ux * vy - uy * vx;
        longest = Math.max(longest, vx * vx + vy * vy + vz * vz);
        ux = vx;
        uy = vy;
        uz = vz;
      }
      double area = Math.sqrt(nx * nx + ny * ny + nz * nz);
      return !Double.isFinite(longest) || area > STRAIGHT * longest;
    }

    private void crowded(ParsedNode node, String field, GeometryFindings findings) {
      Arrays.sort(edges, 0, edgeCount);
      int crowded = 0;
      long first = -1;
      for (int i = 0; i < edgeCount; ) {
        int same = i;
        while (same < edgeCount && edges[same] == edges[i]) {
          same++;
        }
        if (same - i > 2) {
          first = crowded++ == 0 ? edges[i] : first;
        }
        i = same;
      }
      if (crowded > 0) {
        String edge = "from point " + (first >>> 32) + " to " + (int) first;
        findings.addAt(GeometryRules.NON_MANIFOLD, node, field, crowded, edge);
      }
    }
  }
}
