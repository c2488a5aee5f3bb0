package org.selectiverenderer.browser.instance;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;

/**
 * An instance of a light. {@link #world()} is the matrix from its local coordinates to the world.
 */
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

  /** Returns whether the light is on and shown. */
  public boolean on() {
    return shown && light.on();
  }

  @Override
  public void changed(Node node, int field) {
    boolean wasGlobal = light.global();
    light = LightReader.read(node);
    tree.lightChanged();
    if (light.global() != wasGlobal) {
      tree.structureChanged();
    }
  }

  @Override
  void show(boolean show, InstanceTree tree) {
    if (show != shown) {
      shown = show;
      tree.lightChanged();
    }
  }

  @Override
  void moved(InstanceTree tree) {
    tree.lightChanged(); // world() is the parent's matrix.
  }
}
