package org.selectiverenderer.validation.geometry;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Accesses the vertex data that geometry nodes refer to by index: points, normals, colours, texture
 * coordinates.
 */
final class VertexDataAccessor {
  private VertexDataAccessor() {}

  /**
   * Returns the node in a field; null if the type has no such field or the file does not give it.
   */
  static @Nullable NodeView in(NodeView geometry, String field) {
    return geometry.type().field(field).filter(f -> f.type() == FieldType.SFNode).isPresent()
        ? geometry.node(field)
        : null;
  }

  /**
   * Returns the number of tuples in a Coordinate, Normal, Color or TextureCoordinate; -1 for other
   * nodes.
   */
  static int count(NodeView data) {
    String field =
        switch (data.type().name()) {
          case "Coordinate", "CoordinateDouble", "TextureCoordinate" -> "point";
          case "Normal" -> "vector";
          case "Color", "ColorRGBA" -> "color";
          default -> "";
        };
    FieldDefinition definition = data.type().field(field).orElse(null);
    if (definition == null || definition.type().components() == 0) {
      return -1;
    }
    Object value = data.value(definition.index());
    int length =
        value instanceof float[] floats
            ? floats.length
            : value instanceof double[] doubles ? doubles.length : 0;
    return length / definition.type().components();
  }

  /** Returns whether vertex data of a geometry node may be set at run time. */
  static boolean filledLater(ParsedNode geometry, GeometryFindingCollector findings) {
    if (findings.filledLater(geometry)) {
      return true;
    }
    for (String field : List.of("coord", "normal", "color", "texCoord")) {
      NodeView data = in(geometry, field);
      if (data != null && findings.filledLater(data)) {
        return true;
      }
    }
    return false;
  }
}
