package org.selectiverenderer.validation.geometry;

import java.util.List;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Checks that indices are within the values that they refer to. Normals, colours and texture
 * coordinates without an index of their own use coordIndex.
 */
final class IndexRangeCheck implements GeometryNodeCheck {
  /**
   * An index.
   *
   * @param fallback the index that is used where this one is empty
   * @param perVertex the field that must be true for the fallback to be used; empty if it always is
   */
  private record Index(String field, String fallback, String data, String what, String perVertex) {}

  private static final List<Index> INDICES =
      List.of(
          new Index("coordIndex", "", "coord", "point", ""),
          new Index("normalIndex", "coordIndex", "normal", "normal", "normalPerVertex"),
          new Index("colorIndex", "coordIndex", "color", "colour", "colorPerVertex"),
          new Index("texCoordIndex", "coordIndex", "texCoord", "texture coordinate", ""),
          new Index("index", "", "coord", "point", ""),
          new Index("index", "", "normal", "normal", "normalPerVertex"),
          new Index("index", "", "color", "colour", "colorPerVertex"),
          new Index("index", "", "texCoord", "texture coordinate", ""));

  @Override
  public void check(ParsedNode node, GeometryFindingCollector findings) {
    for (Index index : INDICES) {
      NodeView data = VertexDataAccessor.in(node, index.data);
      if (data != null && node.type().field(index.field).isPresent()) {
        check(node, index, data, findings);
      }
    }
  }

  private static void check(
      ParsedNode node, Index index, NodeView data, GeometryFindingCollector findings) {
    String field = index.field;
    boolean own = !index.field.equals("index") && node.ints(field).length > 0;
    if (!own && !index.perVertex.isEmpty() && !flag(node, index.perVertex)) {
      return; // one value per face
    }
    if (!own && !index.fallback.isEmpty()) {
      field = index.fallback;
    }
    int count = VertexDataAccessor.count(data);
    int[] indices = node.ints(field);
    for (int value : indices) {
      if (count >= 0 && value >= count) {
        if (VertexDataAccessor.filledLater(node, findings)) {
          return;
        }
        findings.addAt(
            GeometryRules.INDEX_OUT_OF_RANGE, node, field, field, index.what, value, count);
        return;
      }
    }
  }

  static boolean flag(ParsedNode node, String field) {
    return node.type().field(field).isEmpty() || node.bool(field);
  }
}
