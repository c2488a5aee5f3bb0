package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleConsumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.sai.InlineSceneAccess;
import org.selectiverenderer.sai.MetadataChangeAccess;
import org.selectiverenderer.sai.NodeNameAccess;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;

/** A scope of DEF names: the scene that the browser shows, or the scene in an Inline. */
final class SceneScope {
  private final X3DExecutionContext scene;
  private final UnaryOperator<X3DNode> bodies;
  private final @Nullable NodeNameAccess namesAccess;
  private final @Nullable SceneScope outer;
  private final @Nullable X3DNode inline;
  private final int number;
  private int inlines;

  /**
   * Makes the scope of the scene that the browser shows.
   *
   * @param bodies maps prototype instances to the first nodes of their bodies, and other nodes to
   *     themselves
   * @param namesAccess tells the names of nodes; null where the browser does not
   */
  SceneScope(
      X3DExecutionContext scene,
      UnaryOperator<X3DNode> bodies,
      @Nullable NodeNameAccess namesAccess) {
    this(scene, bodies, namesAccess, null, null, 0);
  }

  private SceneScope(
      X3DExecutionContext scene,
      UnaryOperator<X3DNode> bodies,
      @Nullable NodeNameAccess namesAccess,
      @Nullable SceneScope outer,
      @Nullable X3DNode inline,
      int number) {
    this.scene = scene;
    this.bodies = bodies;
    this.namesAccess = namesAccess;
    this.outer = outer;
    this.inline = inline;
    this.number = number;
  }

  /** Returns a number for an Inline of this scene, which it keeps whatever it shows. */
  int nextInline() {
    return ++inlines;
  }

  /** Returns the scope of the scene in an Inline of this scene. */
  SceneScope inner(X3DNode inlineHere, int itsNumber, X3DExecutionContext content) {
    return new SceneScope(content, bodies, namesAccess, this, inlineHere, itsNumber);
  }

  X3DExecutionContext scene() {
    return scene;
  }

  /**
   * Returns the nodes of an array without nulls, with prototype instances replaced by the first
   * nodes of their bodies.
   */
  List<X3DNode> opened(@Nullable X3DNode[] nodes) {
    List<X3DNode> found = new ArrayList<>(nodes.length);
    for (X3DNode node : nodes) {
      if (node != null) {
        found.add(bodies.apply(node));
      }
    }
    return List.copyOf(found);
  }

  /** Returns the DEF names in this scene of some nodes; of several names of a node, the last. */
  Map<X3DNode, String> namesOf(Set<X3DNode> nodes) {
    if (namesAccess != null) {
      return namesAccess.namesOf(scene, nodes);
    }
    Map<X3DNode, String> names = new HashMap<>();
    for (String name : scene.getNamedNodes()) {
      X3DNode node = named(name);
      if (nodes.contains(node)) {
        names.put(node, name);
      }
    }
    return names;
  }

  /** Listens for changes of a node's metadata as a whole; empty where the browser cannot. */
  Optional<InlineSceneAccess.Registration> watchMetadata(X3DNode owner, DoubleConsumer listener) {
    return namesAccess instanceof MetadataChangeAccess metadata
        ? metadata.watchMetadata(owner, listener)
        : Optional.empty();
  }

  /** Returns the node of a DEF name. */
  X3DNode named(String name) {
    return bodies.apply(scene.getNamedNode(name));
  }

  /** Returns whether this is the main scene, not one in an Inline. */
  boolean isMain() {
    return outer == null;
  }

  /**
   * Returns the names of the enclosing Inlines, outermost first, each followed by a slash: {@code
   * Kitchen/Inline#2/}. Empty for the main scene.
   */
  String path() {
    if (outer == null || inline == null) {
      return "";
    }
    String name = outer.namesOf(Set.of(inline)).get(inline);
    return outer.path() + (name == null ? "Inline#" + number : name.strip()) + "/";
  }
}
