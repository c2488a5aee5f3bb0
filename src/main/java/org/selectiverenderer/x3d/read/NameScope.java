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
 * Where names are valid: a scene, or one instance of a prototype's body (X3D 4.0, 4.4.4.3). DEF
 * names of a scope are unknown outside; prototypes are known in the scopes within, too.
 */
final class NameScope {
  /** A node that a name stands for, with the interface that hides it when it is an instance. */
  record Named(ParsedNode node, @Nullable ProtoInstance instance) {}

  private final @Nullable NameScope enclosing;
  private final @Nullable ProtoInstance instance;
  private final Map<String, Named> names = new LinkedHashMap<>();
  private boolean valued;
  private Set<ParsedNode> open = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Map<String, DeclaredPrototype> prototypes = new HashMap<>();
  private final Set<String> lost = new HashSet<>();
  private final Set<String> imported = new HashSet<>();
  private final List<PendingRoute> routes = new ArrayList<>();

  NameScope(@Nullable NameScope enclosing, @Nullable ProtoInstance instance) {
    this.enclosing = enclosing;
    this.instance = instance;
  }

  /** The instance whose body this is; null in a scene. */
  @Nullable ProtoInstance instance() {
    return instance;
  }

  /** Gives a node its name and returns the node that had it before, if any. */
  @Nullable Named define(String name, Named node) {
    return names.put(name, node);
  }

  @Nullable Named find(String name) {
    return names.get(name);
  }

  Map<String, Named> names() {
    return names;
  }

  /** Marks a node whose end tag has not come: a USE of it would make it a part of itself. */
  void open(ParsedNode node) {
    open.add(node);
  }

  void close(ParsedNode node) {
    open.remove(node);
  }

  /**
   * From here on no node is open: a Script's field may hold a node that the Script stands in, since
   * what the field holds is no part of the scene.
   *
   * @return what {@link #reopen} takes
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
   * Whether a value of an instance is read: what that holds may be for a Script, so it may name a
   * node that is open.
   *
   * @return what it was before
   */
  boolean valued(boolean now) {
    boolean before = valued;
    valued = now;
    return before;
  }

  boolean valued() {
    return valued;
  }

  /** Forgets all but the prototypes, when nothing more is read in the scope. */
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

  /** Marks the name of a node that is left out, which has been told. */
  void lose(String name) {
    lost.add(name);
  }

  /** Whether the node of that name is left out for a reason that has been told. */
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

  void add(PendingRoute route) {
    routes.add(route);
  }

  List<PendingRoute> routes() {
    return routes;
  }
}
