package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;

/** A scope of DEF names: the scene that the browser shows, or the scene in an Inline. */
final class SceneScope {
  private final X3DExecutionContext scene;
  private final UnaryOperator<X3DNode> bodies;
  private final @Nullable SceneScope outer;
  private final @Nullable X3DNode inline;
  private final int number;
  private int inlines;

  /**
   * Makes the scope of the scene that the browser shows.
   *
   * @param bodies maps prototype instances to the first nodes of their bodies, and other nodes to
   *     themselves
   */
  SceneScope(X3DExecutionContext scene, UnaryOperator<X3DNode> bodies) {
    this(scene, bodies, null, null, 0);
  }

  private SceneScope(
      X3DExecutionContext scene,
      UnaryOperator<X3DNode> bodies,
      @Nullable SceneScope outer,
      @Nullable X3DNode inline,
      int number) {
    this.scene = scene;
    this.bodies = bodies;
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
    return new SceneScope(content, bodies, this, inlineHere, itsNumber);
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
    String name = "Inline#" + number;
    for (String candidate : outer.scene.getNamedNodes()) {
      if (inline.equals(outer.named(candidate))) {
        name = candidate.strip();
      }
    }
    return outer.path() + name + "/";
  }
}
