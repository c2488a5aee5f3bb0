package org.selectiverenderer.validation.geometry;

import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Checks numbers of values that must agree: normals, colours, points, faces and heights. */
final class ValueCountCheck implements GeometryNodeCheck {
  private static final String[][] PROPERTIES = {
    {"normal", "normalIndex", "normalPerVertex", "normals"},
    {"color", "colorIndex", "colorPerVertex", "colours"},
    {"texCoord", "texCoordIndex", "", "texture coordinates"}
  };

  @Override
  public void check(ParsedNode node, GeometryFindingCollector findings) {
    switch (node.type().name()) {
      case "IndexedFaceSet" -> indexed(node, findings);
      case "ElevationGrid" -> grid(node, findings);
      case "TriangleSet" -> groups(node, 3, findings);
      case "QuadSet" -> groups(node, 4, findings);
      case "TriangleFanSet" -> runs(node, "fanCount", findings);
      case "TriangleStripSet" -> runs(node, "stripCount", findings);
      case "LineSet" -> runs(node, "vertexCount", findings);
      case "IndexedTriangleSet" -> indices(node, 3, findings);
      case "IndexedQuadSet" -> indices(node, 4, findings);
      case "Extrusion" -> extrusion(node, findings);
      default -> {}
    }
  }

  private static void indexed(ParsedNode node, GeometryFindingCollector findings) {
    int[] faces = node.ints("coordIndex");
    for (String[] property : PROPERTIES) {
      NodeView data = VertexDataAccessor.in(node, property[0]);
      if (data == null || VertexDataAccessor.count(data) < 0) {
        continue;
      }
      int[] own = node.ints(property[1]);
      boolean perVertex = property[2].isEmpty() || node.bool(property[2]);
      int needed = perVertex ? length(faces) : count(faces);
      if (own.length > 0) {
        // The -1 after the last face is optional.
        int given = perVertex ? length(own) : own.length;
        report(node, property[1], given, "indices", needed, findings);
      } else if (!perVertex) {
        report(node, property[0], VertexDataAccessor.count(data), property[3], needed, findings);
      }
    }
  }

  private static void grid(ParsedNode node, GeometryFindingCollector findings) {
    long x = node.integer("xDimension");
    long z = node.integer("zDimension");
    if (x < 2 || z < 2) {
      return;
    }
    report(node, "height", node.floats("height").length, "heights", x * z, findings);
    for (String[] property : PROPERTIES) {
      NodeView data = VertexDataAccessor.in(node, property[0]);
      int count = data == null ? -1 : VertexDataAccessor.count(data);
      boolean perVertex = property[2].isEmpty() || node.bool(property[2]);
      if (count >= 0) {
        long needed = perVertex ? x * z : (x - 1) * (z - 1);
        report(node, property[0], count, property[3], needed, findings);
      }
    }
  }

  /**
   * Checks sets of triangles or quads without an index: the number of points must be a multiple of
   * 3 or 4, and equal to that of normals and colours.
   */
  private static void groups(ParsedNode node, int size, GeometryFindingCollector findings) {
    int points = points(node, findings);
    if (points > 0 && points % size != 0 && !VertexDataAccessor.filledLater(node, findings)) {
      long needed = (points / size + 1L) * size;
      findings.addAt(GeometryRules.COUNTS, node, "coord", "coord", points, "points", needed);
    }
  }

  private static void indices(ParsedNode node, int size, GeometryFindingCollector findings) {
    int length = node.ints("index").length;
    if (length % size != 0 && !VertexDataAccessor.filledLater(node, findings)) {
      long needed = (length / size + 1L) * size;
      findings.addAt(GeometryRules.COUNTS, node, "index", "index", length, "indices", needed);
    }
  }

  /** Checks fans, strips and lines, whose points come in runs of given lengths. */
  private static void runs(ParsedNode node, String field, GeometryFindingCollector findings) {
    int points = points(node, findings);
    long needed = 0;
    for (int run : node.ints(field)) {
      needed += Math.max(0, run);
    }
    if (points > 0) {
      report(node, "coord", points, "points", needed, findings);
    }
  }

  /** Returns the number of points, which normals and colours must match. */
  private static int points(ParsedNode node, GeometryFindingCollector findings) {
    NodeView coordinates = node.node("coord");
    int points = coordinates == null ? -1 : VertexDataAccessor.count(coordinates);
    for (String[] property : PROPERTIES) {
      NodeView data = VertexDataAccessor.in(node, property[0]);
      int count = data == null ? -1 : VertexDataAccessor.count(data);
      if (count >= 0 && (property[2].isEmpty() || IndexRangeCheck.flag(node, property[2]))) {
        report(node, property[0], count, property[3], points, findings);
      }
    }
    return points;
  }

  private static void extrusion(ParsedNode node, GeometryFindingCollector findings) {
    int spine = node.floats("spine").length / 3;
    int scales = node.floats("scale").length / 2;
    int turns = node.floats("orientation").length / 4;
    report(node, "spine", spine, "points", 2, findings);
    report(node, "crossSection", node.floats("crossSection").length / 2, "points", 2, findings);
    if (spine < 2) {
      return;
    }
    if (scales > 1) {
      report(node, "scale", scales, "scales", spine, findings);
    }
    if (turns > 1) {
      report(node, "orientation", turns, "orientations", spine, findings);
    }
  }

  private static void report(
      ParsedNode node,
      String field,
      long count,
      String what,
      long needed,
      GeometryFindingCollector findings) {
    if (count < needed && !VertexDataAccessor.filledLater(node, findings)) {
      findings.addAt(GeometryRules.COUNTS, node, field, field, count, what, needed);
    }
  }

  private static int length(int[] indices) {
    boolean ended = indices.length > 0 && indices[indices.length - 1] == -1;
    return ended ? indices.length - 1 : indices.length;
  }

  private static int count(int[] faces) {
    int count = 0;
    for (int i = 0; i < faces.length; i++) {
      boolean last = i + 1 == faces.length || faces[i + 1] == -1;
      count += faces[i] != -1 && last ? 1 : 0;
    }
    return count;
  }
}
