package org.selectiverenderer.x3d.vrml;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * A scope of names: the nodes in a scene or in one prototype's body, and the prototypes declared
 * there and in enclosing scopes (X3D 4.0, 4.4.4.3).
 */
final class VrmlScope {
  /**
   * A named node.
   *
   * @param element the name of its element
   * @param prototype the name of its prototype; empty for a node of the standard
   */
  record Named(String element, String prototype) {}

  private final @Nullable VrmlScope enclosing;
  private final Map<String, Named> names = new HashMap<>();
  private final Map<String, Map<String, FieldType>> prototypes = new HashMap<>();

  VrmlScope(@Nullable VrmlScope enclosing) {
    this.enclosing = enclosing;
  }

  void define(String name, Named named) {
    names.put(name, named);
  }

  @Nullable Named find(String name) {
    return names.get(name);
  }

  void declare(String prototype, Map<String, FieldType> fields) {
    prototypes.put(prototype, fields);
  }

  /** Returns the field types of a prototype; null if there is none of that name. */
  @Nullable Map<String, FieldType> prototype(String name) {
    for (VrmlScope scope = this; scope != null; scope = scope.enclosing) {
      Map<String, FieldType> fields = scope.prototypes.get(name);
      if (fields != null) {
        return fields;
      }
    }
    return null;
  }
}
