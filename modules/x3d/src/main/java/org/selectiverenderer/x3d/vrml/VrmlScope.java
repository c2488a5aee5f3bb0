package org.selectiverenderer.x3d.vrml;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
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
  private final boolean repeatsNames;
  private final Map<String, Named> names = new HashMap<>();
  private final Map<String, String> current = new HashMap<>();
  private final Set<String> taken = new HashSet<>();
  private final Map<String, Map<String, FieldType>> prototypes = new HashMap<>();

  private VrmlScope(@Nullable VrmlScope enclosing, boolean repeatsNames) {
    this.enclosing = enclosing;
    this.repeatsNames = repeatsNames;
  }

  /**
   * Creates the scope of a scene.
   *
   * @param repeatsNames whether several nodes may have the same name
   */
  static VrmlScope ofScene(boolean repeatsNames) {
    return new VrmlScope(null, repeatsNames);
  }

  /** Creates the scope of the body of a prototype that is declared in this one. */
  VrmlScope ofPrototype() {
    return new VrmlScope(this, repeatsNames);
  }

  void define(String name, Named named) {
    names.put(name, named);
  }

  /**
   * Returns the name by which the elements call a node that is defined now. A file of VRML97 may
   * give a name to several nodes, of which the latest one so far is meant (ISO/IEC 14772-1, 4.6.2);
   * X3D names one. So the second one of {@code Seat} becomes {@code Seat_2}, or the next number
   * that is free so far.
   */
  String nameForNewNode(String name) {
    if (!repeatsNames) {
      return name;
    }
    String unique = name;
    for (int i = 2; !taken.add(unique); i++) {
      unique = name + "_" + i;
    }
    current.put(name, unique);
    return unique;
  }

  /** Returns the name by which the elements call the latest node that the file calls so. */
  String currentName(String name) {
    return current.getOrDefault(name, name);
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
