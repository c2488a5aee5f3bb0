package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.field.FieldType;

/** A field declaration, given by a {@code field} element of a prototype interface or Script. */
record FieldDeclaration(String name, FieldType type, AccessType access) {
  /** Reads the current element; null if it is not a {@code field} or an attribute is invalid. */
  static @Nullable FieldDeclaration of(ElementCursor in) {
    String name = in.attribute("name");
    String typeName = in.attribute("type");
    String accessName = in.attribute("accessType");
    FieldType type = null;
    for (FieldType candidate : FieldType.values()) {
      type = candidate.name().equals(typeName) ? candidate : type;
    }
    AccessType access = null;
    for (AccessType candidate : AccessType.values()) {
      access = candidate.spelling().equals(accessName) ? candidate : access;
    }
    return !in.name().equals("field") || name == null || type == null || access == null
        ? null
        : new FieldDeclaration(name, type, access);
  }
}
