package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldAccess;
import org.selectiverenderer.x3d.field.FieldType;

/** A field declaration, given by a {@code field} element of a prototype interface or Script. */
record FieldElement(String name, FieldType type, FieldAccess access) {
  /** Reads the current element; null if it is not a {@code field} or an attribute is invalid. */
  static @Nullable FieldElement of(ElementCursor in) {
    String name = in.attribute("name");
    String typeName = in.attribute("type");
    String accessName = in.attribute("accessType");
    FieldType type = null;
    for (FieldType candidate : FieldType.values()) {
      type = candidate.name().equals(typeName) ? candidate : type;
    }
    FieldAccess access = null;
    for (FieldAccess candidate : FieldAccess.values()) {
      access = candidate.spelling().equals(accessName) ? candidate : access;
    }
    return !in.name().equals("field") || name == null || type == null || access == null
        ? null
        : new FieldElement(name, type, access);
  }
}
