package org.selectiverenderer.browser.instance;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/** One occurrence of a node in the scene: a node that is USEd twice has two instances. */
public abstract sealed class Instance
    permits GroupInstance, ShapeInstance, LightInstance, ScopedEffectInstance, NonVisualInstance {
  static final Matrix4dc IDENTITY = new Matrix4d();

  private final Node node;
  final @Nullable GroupInstance parent;
  boolean shown;

  Instance(Node node, @Nullable GroupInstance parent) {
    this.node = node;
    this.parent = parent;
  }

  public Node node() {
    return node;
  }

  /** Returns the parent group, or null for the root. */
  public @Nullable GroupInstance parent() {
    return parent;
  }

  /** Returns whether every Switch, LOD and {@code visible} field above the instance shows it. */
  public boolean shown() {
    return shown;
  }

  /**
   * Returns the matrix from the parent's local coordinates, in which the node's fields are given,
   * to the world.
   */
  public Matrix4dc world() {
    return parent == null ? IDENTITY : parent.content();
  }

  /** Marks this instance and all below it as shown or hidden. */
  abstract void show(boolean show, InstanceTree tree);

  /** Updates the instance after a change of a transformation above it. */
  abstract void moved(InstanceTree tree);
}
