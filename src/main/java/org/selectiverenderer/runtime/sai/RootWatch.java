package org.selectiverenderer.runtime.sai;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.ListenerOfField;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;

/** Hears when nodes come to or leave the top of a scene that is shown, as listeners hear it. */
final class RootWatch implements ListenerOfField, AutoCloseable {
  private final Node root;
  private final int children;
  private final Runnable onChange;

  RootWatch(Scene scene, Runnable onChange) {
    this.root = scene.root();
    this.children = root.type().indexOf("children");
    this.onChange = onChange;
    root.addListener(children, this);
  }

  @Override
  public int field() {
    return children;
  }

  @Override
  public void fieldChanged(Node node, int index, @Nullable Object value, double time) {
    onChange.run();
  }

  @Override
  public void close() {
    root.removeListener(children, this);
  }
}
