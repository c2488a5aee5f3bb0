package org.selectiverenderer.validation.geometry;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Finds degenerate faces (without area) and non-manifold edges (of more than two faces). */
final class MeshQualityCheck implements GeometryNodeCheck {
  @Override
  public void check(ParsedNode node, GeometryFindingCollector findings) {
    NodeView coordinates = VertexDataAccessor.in(node, "coord");
    if (coordinates == null || !coordinates.type().name().equals("Coordinate")) {
      return;
    }
    float[] points = coordinates.floats("point");
    switch (node.type().name()) {
      case "IndexedFaceSet" ->
          new Faces(node.ints("coordIndex"), points, 0).report(node, "coordIndex", findings);
      case "IndexedTriangleSet" ->
          new Faces(node.ints("index"), points, 3).report(node, "index", findings);
      case "IndexedQuadSet" ->
          new Faces(node.ints("index"), points, 4).report(node, "index", findings);
      case "TriangleSet" -> new Faces(inOrder(points), points, 3).report(node, "coord", findings);
      case "QuadSet" -> new Faces(inOrder(points), points, 4).report(node, "coord", findings);
      // Strips and fans are not checked: degenerate triangles are customary in them.
      default -> {}
    }
  }

  private static int[] inOrder(float[] points) {
    return IntStream.range(0, points.length / 3).toArray();
  }

  /** The faces of one node. */
  private static final class Faces {
    private final int[] indices;
    private final float[] points;
    private final int size;
    private final long[] edges;
    private int edgeCount;
    private int faces;
    private int flat;
    private int firstFlat;

    /**
     * @param size number of points of each face; 0 where -1 ends each face
     */
    Faces(int[] indices, float[] points, int size) {
      this.indices = indices;
      this.points = points;
      this.size = size;
      this.edges = new long[indices.length];
    }

    void report(ParsedNode node, String field, GeometryFindingCollector findings) {
      int from = 0;
      for (int i = 0; i <= indices.length; i++) {
        boolean ends = size == 0 ? i == indices.length || indices[i] < 0 : i - from == size;
        if (ends) {
          face(from, i);
          from = size == 0 ? i + 1 : i;
        }
      }
      if (flat > 0) {
        findings.addAt(GeometryRules.NO_AREA, node, field, flat, faces, firstFlat);
      }
      crowded(node, field, findings);
    }

    private void face(int from, int to) {
      if (to == from || !known(from, to)) {
        return;
      }
      if (to - from < 3 || !TriangleMath.hasArea(points, indices, from, to)) {
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

    private void crowded(ParsedNode node, String field, GeometryFindingCollector findings) {
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
