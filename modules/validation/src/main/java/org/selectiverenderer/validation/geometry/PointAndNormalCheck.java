package org.selectiverenderer.validation.geometry;

import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Finds points too far from the origin for single precision, and normals that do not have length 1.
 */
final class PointAndNormalCheck implements GeometryNodeCheck {
  private static final float FAR = 1e7f;
  private static final double TOLERANCE = 0.01;

  @Override
  public void check(ParsedNode node, GeometryFindingCollector findings) {
    switch (node.type().name()) {
      case "Coordinate" -> near(node, "point", findings);
      case "Normal" -> normals(node, findings);
      default -> {}
    }
  }

  private static void near(ParsedNode node, String field, GeometryFindingCollector findings) {
    float[] values = node.floats(field);
    for (int i = 0; i < values.length; i++) {
      if (!(Math.abs(values[i]) <= FAR)) {
        findings.addAt(GeometryRules.TOO_FAR, node, field, field, values[i], i);
        return;
      }
    }
  }

  private static void normals(ParsedNode node, GeometryFindingCollector findings) {
    float[] v = node.floats("vector");
    int wrong = 0;
    int first = -1;
    for (int i = 0; i + 2 < v.length; i += 3) {
      double length = Math.sqrt((double) v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2]);
      if (!(Math.abs(length - 1) <= TOLERANCE)) {
        first = wrong++ == 0 ? i / 3 : first;
      }
    }
    if (wrong > 0) {
      findings.addAt(GeometryRules.NORMAL_LENGTH, node, "vector", wrong, v.length / 3, first);
    }
  }
}
