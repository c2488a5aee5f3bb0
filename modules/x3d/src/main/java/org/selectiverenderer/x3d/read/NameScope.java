package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * A scope of names: a scene, or one instance of a prototype's body (X3D 4.0, 4.4.4.3). The DEF
 * names of a scope are invisible outside; prototypes are also visible in nested scopes.
 */
final class NameScope {
  /** The node of a name, with its prototype interface if it is an instance. */
  record Named(ParsedNode node, @Nullable ProtoInstance instance) {}

  private final @Nullable NameScope enclosing;
  private final @Nullable ProtoInstance instance;
  private final Map<String, Named> names = new LinkedHashMap<>();
  private boolean valued;
  private Set<ParsedNode> open = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Map<String, DeclaredPrototype> prototypes = new HashMap<>();
  private final Set<String> lost = new HashSet<>();
  private final Set<String> imported = new HashSet<>();
  private final List<UnresolvedRoute> routes = new ArrayList<>();

  NameScope(@Nullable NameScope enclosing, @Nullable ProtoInstance instance) {
    this.enclosing = enclosing;
    this.instance = instance;
  }

  /** Returns the instance whose body this is; null in a scene. */
  @Nullable ProtoInstance instance() {
    return instance;
  }

  /** Defines a name and returns the node that had it before, if any. */
  @Nullable Named define(String name, Named node) {
    return names.put(name, node);
  }

  @Nullable Named find(String name) {
    return names.get(name);
  }

  Map<String, Named> names() {
    return names;
  }

  /** Marks a node as open, before its end tag: a USE of it would make it contain itself. */
  void open(ParsedNode node) {
    open.add(node);
  }

  void close(ParsedNode node) {
    open.remove(node);
  }

  /**
   * Marks all nodes as not open: the field of a Script may refer to the Script's ancestors, since
   * its value is not part of the scene.
   *
   * @return the open nodes, for {@link #reopen}
   */
  Set<ParsedNode> closeAll() {
    Set<ParsedNode> before = open;
    open = Collections.newSetFromMap(new IdentityHashMap<>());
    return before;
  }

  void reopen(Set<ParsedNode> before) {
    open = before;
  }

  boolean isOpen(ParsedNode node) {
    return open.contains(node);
  }

  /**
   * Sets whether a field value of an instance is being read, which may be for a Script and so may
   * refer to an open node.
   *
   * @return the setting before
   */
  boolean valued(boolean now) {
    boolean before = valued;
    valued = now;
    return before;
  }

  boolean valued() {
    return valued;
  }

  /** Clears everything but the prototypes, when the scope has been read. */
  void keepPrototypes() {
    names.clear();
    open.clear();
    lost.clear();
    imported.clear();
    routes.clear();
  }

  void declare(DeclaredPrototype prototype) {
    prototypes.put(prototype.name(), prototype);
  }

  @Nullable DeclaredPrototype prototype(String name) {
    for (NameScope scope = this; scope != null; scope = scope.enclosing) {
      DeclaredPrototype found = scope.prototypes.get(name);
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  /** Marks the name of a node that was left out, which has been reported. */
  void lose(String name) {
    lost.add(name);
  }

  /** Returns whether the node of a name was left out for a reported reason. */
  boolean isLost(String name) {
    return lost.contains(name) && !names.containsKey(name);
  }

  Set<String> prototypeNames() {
    Set<String> known = new HashSet<>();
    for (NameScope scope = this; scope != null; scope = scope.enclosing) {
      known.addAll(scope.prototypes.keySet());
    }
    return known;
  }

  void addImport(String name) {
    imported.add(name);
  }

  boolean isImported(String name) {
    return imported.contains(name);
  }

  void add(UnresolvedRoute route) {
    routes.add(route);
  }

  List<UnresolvedRoute> routes() {
    return routes;
  }
}
