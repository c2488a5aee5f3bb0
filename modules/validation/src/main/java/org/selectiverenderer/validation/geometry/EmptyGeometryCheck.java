package org.selectiverenderer.validation.geometry;

import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Finds geometry that draws nothing. */
final class EmptyGeometryCheck implements GeometryNodeCheck {
  @Override
  public void check(ParsedNode node, GeometryFindingCollector findings) {
    if (!node.type().is("X3DGeometryNode")) {
      return;
    }
    String missing = missing(node);
    if (!missing.isEmpty() && !VertexDataAccessor.filledLater(node, findings)) {
      findings.add(GeometryRules.NOTHING, node, node.type().name(), missing);
    }
  }

  private static String missing(ParsedNode node) {
    if (node.type().field("coord").isPresent()) {
      NodeView points = node.node("coord");
      if (points == null || VertexDataAccessor.count(points) == 0) {
        return "points";
      }
    }
    for (String field : new String[] {"coordIndex", "index"}) {
      if (node.type().field(field).isPresent() && node.ints(field).length == 0) {
        return node.type().name().contains("Line") ? "lines" : "faces";
      }
    }
    return node.type().name().equals("Text") && node.strings("string").length == 0 ? "text" : "";
  }
}
