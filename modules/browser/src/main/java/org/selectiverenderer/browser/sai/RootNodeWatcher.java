package org.selectiverenderer.browser.sai;

import java.util.function.DoubleConsumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.scene.SingleFieldListener;

/**
 * Calls a consumer with the time stamp when root nodes are added to or removed from a scene that is
 * shown, in the way of field listeners.
 */
final class RootNodeWatcher implements SingleFieldListener, AutoCloseable {
  private final Node root;
  private final int children;
  private final DoubleConsumer onChange;

  RootNodeWatcher(Scene scene, DoubleConsumer onChange) {
    this.root = scene.root();
    this.children = children(scene);
    this.onChange = onChange;
    root.addListener(children, this);
  }

  /** Returns the field of a scene's root that holds the root nodes. */
  static int children(Scene scene) {
    return scene.root().type().indexOf("children");
  }

  @Override
  public int field() {
    return children;
  }

  @Override
  public void fieldChanged(Node node, int index, @Nullable Object value, double time) {
    onChange.accept(time);
  }

  @Override
  public void close() {
    root.removeListener(children, this);
  }
}
