package org.selectiverenderer.app.head;

import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.scene.Node;

/**
 * Resolves a shape to the object that it belongs to, and names the object by its DEF. A shape
 * belongs to
 *
 * <ol>
 *   <li>the nearest Switch with a DEF above it, which holds an object's versions;
 *   <li>else the outermost Inline with a DEF below the room: a file is an object as a rule,
 *       wherever it stands, and what a file names in itself are parts;
 *   <li>else the outermost grouping node with a DEF below the room: a chair rather than its leg;
 *   <li>else the room: bare walls;
 *   <li>else whatever has a DEF at all, such as the shape itself.
 * </ol>
 *
 * <p>A room is a grouping node with a DEF at the top level of the scene that holds other objects; a
 * node at the top level that holds none is an object itself. A shape below no DEF belongs to no
 * object. Results are cached, so that asking for the same shape in every frame is cheap. Belongs to
 * the thread that steps the world; serves one instance tree.
 */
final class SceneObjectResolver {
  /**
   * An object.
   *
   * @param name its DEF
   * @param node the node that has it
   */
  record Named(String name, Node node) {
    /** Returns whichChoice of the Switch; -1 if the node is not a Switch. */
    int version() {
      return node.type().name().equals("Switch")
              && node.value(node.type().indexOf("whichChoice")) instanceof Integer at
          ? at
          : -1;
    }
  }

  private final InstanceTree tree;
  private final Map<Instance, Optional<Named>> found = new IdentityHashMap<>();
  private final Map<Instance, Boolean> rooms = new IdentityHashMap<>();
  private long structure;

  SceneObjectResolver(InstanceTree tree) {
    this.tree = tree;
    structure = tree.structureVersion();
  }

  /** Returns the object that a shape belongs to; empty if no node above it has a DEF. */
  Optional<Named> of(ShapeInstance shape) {
    if (structure != tree.structureVersion()) {
      structure = tree.structureVersion();
      found.clear();
      rooms.clear();
    }
    return found.computeIfAbsent(shape, at -> search(shape));
  }

  private Optional<Named> search(ShapeInstance shape) {
    Map<Rank, Named> best = new HashMap<>();
    for (Instance at = shape; at != null; at = at.parent()) {
      Node node = at.node();
      String name = name(node);
      if (name == null) {
        continue;
      }
      Named named = new Named(name, node);
      String type = node.type().name();
      if (type.equals("Switch")) {
        return Optional.of(named);
      }
      boolean top = at.parent() == tree.root();
      if (top && isRoom(at)) {
        best.put(Rank.ROOM, named);
      } else if (type.equals("Inline")) {
        best.put(Rank.INLINE, named);
      } else if (at instanceof GroupInstance) {
        best.put(Rank.GROUP, named); // The last one is the outermost.
      } else {
        best.put(Rank.OTHER, named);
      }
    }
    for (Rank rank : Rank.values()) {
      if (best.containsKey(rank)) {
        return Optional.of(best.get(rank));
      }
    }
    return Optional.empty();
  }

  private enum Rank {
    INLINE,
    GROUP,
    ROOM,
    OTHER
  }

  /** Returns whether a node at the top level of the scene is a room, which holds objects. */
  boolean isRoom(Instance top) {
    return rooms.computeIfAbsent(
        top, at -> at instanceof GroupInstance group && holds(group, at.node()));
  }

  /**
   * Returns whether a group holds objects. Groups in an inlined file are parts of an object;
   * Switches and Inlines are objects.
   */
  private static boolean holds(GroupInstance group, Node top) {
    boolean file = top.type().name().equals("Inline");
    for (Instance child : group.children()) {
      if (child == null) {
        continue;
      }
      String type = child.node().type().name();
      boolean object = type.equals("Switch") || type.equals("Inline") || !file;
      if (child instanceof GroupInstance inner
          && (object && name(child.node()) != null || holds(inner, top))) {
        return true;
      }
    }
    return false;
  }

  private static @Nullable String name(Node node) {
    String name = node.name();
    return name == null || name.isEmpty() ? null : name;
  }
}
