package org.selectiverenderer.runtime.instance;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;

/** A node in one place of the scene: a node that is USEd twice has two instances. */
public abstract sealed class Instance
    permits GroupInstance, ShapeInstance, LightInstance, EffectInstance, PlainInstance {
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

  /** The group it stands in, or null for the root. */
  public @Nullable GroupInstance parent() {
    return parent;
  }

  /** Whether every Switch, LOD and {@code visible} field above it lets it be seen. */
  public boolean shown() {
    return shown;
  }

  /** From its parent's local coordinates, in which the node's fields are given, to the world. */
  public Matrix4dc world() {
    return parent == null ? IDENTITY : parent.content();
  }

  /** Marks it and what is below as shown or not. */
  abstract void show(boolean show, InstanceTree tree);

  /** Follows a change of a transformation above. */
  abstract void moved(InstanceTree tree);
}
