package org.selectiverenderer.browser.instance;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/** An instance of a node that is not drawn: a sensor, a viewpoint, an interpolator. */
final class NonVisualInstance extends Instance {
  NonVisualInstance(Node node, @Nullable GroupInstance parent) {
    super(node, parent);
  }

  @Override
  void show(boolean show, InstanceTree tree) {
    shown = show;
  }

  @Override
  void moved(InstanceTree tree) {
    tree.plainMoved(node()); // No matrix to update: world() is the parent's.
  }
}
