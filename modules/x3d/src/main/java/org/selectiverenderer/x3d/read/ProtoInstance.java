package org.selectiverenderer.x3d.read;

import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;

/** An instance of a prototype: its field values, and the IS connections of its fields. */
final class ProtoInstance {
  /** A node field in the body that an IS element connects. */
  record Connection(NameScope.Named node, String field) {}

  private final ProtoDeclaration declaration;
  private final SourceLocation location;
  private final int number;
  private final int within;
  private final Map<String, Object> values = new HashMap<>();
  private final Map<String, Set<Connection>> connections = new HashMap<>();
  private final Set<ParsedNode> turning = Collections.newSetFromMap(new IdentityHashMap<>());

  /**
   * Creates an instance.
   *
   * @param number the number among the instances of the file
   * @param enclosing the instance whose body contains it, if any
   * @param location the element that stands for it
   */
  ProtoInstance(
      ProtoDeclaration declaration,
      int number,
      @Nullable ProtoInstance enclosing,
      SourceLocation location) {
    this.declaration = declaration;
    this.location = location;
    this.number = number;
    this.within = enclosing == null ? -1 : enclosing.number;
  }

  SourceLocation location() {
    return location;
  }

  int number() {
    return number;
  }

  /** Returns the number of the instance whose body contains it; -1 for none. */
  int within() {
    return within;
  }

  ProtoDeclaration declaration() {
    return declaration;
  }

  void give(String field, Object value) {
    values.put(field, value);
  }

  /** Returns the value of a field; null if neither instance nor declaration gives one. */
  @Nullable Object value(ProtoDeclaration.Field field) {
    Object value = values.get(field.name());
    return value != null ? value : field.value();
  }

  /** Marks a node given to a field as one that contains an ancestor of the instance. */
  void turnsBack(ParsedNode given) {
    turning.add(given);
  }

  /** Marks all such nodes of another instance. */
  void turnsBack(ProtoInstance from) {
    turning.addAll(from.turning);
  }

  boolean isTurningBack(ParsedNode given) {
    return turning.contains(given);
  }

  boolean given(String field) {
    return values.containsKey(field);
  }

  void connect(String field, Connection connection) {
    connections.computeIfAbsent(field, name -> new LinkedHashSet<>()).add(connection);
  }

  Set<Connection> connections(String field) {
    return connections.getOrDefault(field, Set.of());
  }
}
