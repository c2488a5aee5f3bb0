package org.selectiverenderer.models;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.field.FieldType;

/** Tells whether an appearance has a texture and so needs texture coordinates. */
final class TextureUsage {
  private TextureUsage() {}

  static boolean used(@Nullable NodeView node) {
    if (node == null) {
      return false;
    }
    if (node.type().is("X3DTextureNode")) {
      return true;
    }
    for (FieldDefinition field : node.type().fields()) {
      Object value = node.value(field.index());
      if (field.type() == FieldType.SFNode && value instanceof NodeView child && used(child)) {
        return true;
      }
      if (field.type() == FieldType.MFNode
          && value instanceof List<?> children
          && children.stream().anyMatch(child -> used((NodeView) child))) {
        return true;
      }
    }
    return false;
  }
}
