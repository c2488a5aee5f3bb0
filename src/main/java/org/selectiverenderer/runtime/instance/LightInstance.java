package org.selectiverenderer.runtime.instance;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeObserver;

/** A light in one place. {@link #world()} takes its local coordinates to the world. */
public final class LightInstance extends Instance implements NodeObserver {
  private final InstanceTree tree;
  private Light light;

  LightInstance(Node node, @Nullable GroupInstance parent, InstanceTree tree) {
    super(node, parent);
    this.tree = tree;
    light = LightReader.read(node);
  }

  public Light light() {
    return light;
  }

  /** Whether it lights anything now. */
  public boolean on() {
    return shown && light.on();
  }

  @Override
  public void changed(Node node, int field) {
    boolean wasGlobal = light.global();
    light = LightReader.read(node);
    if (light.global() != wasGlobal) {
      tree.structureChanged();
    }
  }

  @Override
  void show(boolean show, InstanceTree tree) {
    shown = show;
  }

  @Override
  void moved(InstanceTree tree) {
    // Its world() is its parent's: nothing is kept here.
  }
}
