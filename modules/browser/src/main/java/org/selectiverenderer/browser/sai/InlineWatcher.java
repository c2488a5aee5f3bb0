package org.selectiverenderer.browser.sai;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.scene.SingleFieldListener;
import org.selectiverenderer.sai.InlineSceneAccess;
import org.selectiverenderer.sai.InlineSceneAccess.Registration;

/**
 * Observes an Inline and tells a listener when it shows another scene, or that scene has other root
 * nodes. The listener is called like field listeners: after the event cascade, in the frame in
 * which a file has arrived.
 */
final class InlineWatcher implements NodeObserver, SingleFieldListener, Registration {
  private final World world;
  private final InlineNode inline;
  private final int load;
  private final InlineSceneAccess.Listener listener;
  private final NodeProxy proxy;
  private @Nullable Scene content;
  private boolean told = true;
  private boolean closed;

  InlineWatcher(
      World world, NodeProxy proxy, InlineNode inline, InlineSceneAccess.Listener listener) {
    this.world = world;
    this.proxy = proxy;
    this.inline = inline;
    this.listener = listener;
    load = inline.type().indexOf("load");
    inline.addObserver(this);
    follow();
  }

  @Override
  public void changed(Node node, int field) {
    if (field == load && told && inline.shown().orElse(null) != content) {
      told = false;
      world.cascade().notify((at, index, value, time) -> tell(time), node, field, null);
    }
  }

  private void tell(double time) {
    told = true;
    if (!closed && !proxy.gone()) {
      follow();
      listener.inlinedSceneChanged(proxy.proxy(), time);
    }
  }

  private void follow() {
    leave();
    content = inline.shown().orElse(null);
    if (content != null) {
      content.root().addListener(RootNodeWatcher.children(content), this);
    }
  }

  private void leave() {
    if (content != null) {
      content.root().removeListener(RootNodeWatcher.children(content), this);
    }
  }

  @Override
  public int field() {
    return content == null ? -1 : RootNodeWatcher.children(content);
  }

  /** Tells that the scene has other root nodes. */
  @Override
  public void fieldChanged(Node node, int index, @Nullable Object value, double time) {
    tell(time);
  }

  @Override
  public void close() {
    closed = true;
    inline.removeObserver(this);
    leave();
  }
}
