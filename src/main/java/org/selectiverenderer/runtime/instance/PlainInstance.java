package org.selectiverenderer.runtime.instance;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;

/** A node that is not drawn, in one place: a sensor, a viewpoint, an interpolator. */
final class PlainInstance extends Instance {
  PlainInstance(Node node, @Nullable GroupInstance parent) {
    super(node, parent);
  }

  @Override
  void show(boolean show, InstanceTree tree) {
    shown = show;
  }

  @Override
  void moved(InstanceTree tree) {
    tree.plainMoved(node()); // Its world() is its parent's: nothing is kept here.
  }
}
