package org.selectiverenderer.runtime.sai;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.scene.InstanceFace;
import org.selectiverenderer.runtime.scene.Node;
import org.web3d.x3d.sai.InvalidBrowserException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.X3DNode;

/**
 * What the SAI objects of one browser share: which object stands for which node, the way of writes
 * into the world, and whether the browser is still there. Thread-safe.
 */
final class Binding {
  private final World world;
  private final SaiTypes types = new SaiTypes();
  private final SaiValues values = new SaiValues(this);
  private final UpdateBuffer updates = new UpdateBuffer();
  private volatile boolean disposed;

  Binding(World world) {
    this.world = world;
  }

  SaiTypes types() {
    return types;
  }

  SaiValues values() {
    return values;
  }

  Problems problems() {
    return world.problems();
  }

  void dispose() {
    disposed = true;
  }

  boolean disposed() {
    return disposed;
  }

  void check() {
    if (disposed) {
      throw new InvalidBrowserException("the browser is disposed of");
    }
  }

  /**
   * The SAI object of a node, always the same; of an instance of a prototype that of its interface.
   * Null for null.
   */
  @Nullable X3DNode wrap(@Nullable Node node) {
    return node == null ? null : proxy(InstanceFace.seen(node, null), true).proxy();
  }

  /** The same of a node. */
  X3DNode wrapped(Node node) {
    return exactly(InstanceFace.seen(node, null));
  }

  /** The SAI object of a node itself, as it is within the body of a prototype. */
  X3DNode exactly(Node node) {
    check();
    return proxy(node, true).proxy();
  }

  /** The SAI object of a node that the application sets up first. */
  X3DNode wrapNew(Node node) {
    return proxy(node, false).proxy();
  }

  private NodeProxy proxy(Node node, boolean realized) {
    synchronized (node) {
      if (node.companion() instanceof NodeProxy known && known.binding() == this) {
        return known;
      }
      NodeProxy made = new NodeProxy(this, node, realized);
      node.companion(made);
      return made;
    }
  }

  /** The node of the scene of an SAI object, which is in use from now on; null for null. */
  @Nullable Node unwrap(@Nullable X3DNode node) {
    return node == null ? null : body(node);
  }

  /** The same of an object: of an instance, the first node of its body. */
  Node body(X3DNode node) {
    return InstanceFace.body(unwrapped(node));
  }

  /**
   * What an SAI object stands for, a node or an interface, which is in use from now on.
   *
   * @throws InvalidNodeException if it is of another browser or disposed of
   */
  Node unwrapped(@Nullable X3DNode node) {
    NodeProxy proxy = find(node);
    proxy.check();
    proxy.realize();
    return proxy.node();
  }

  /** The node of an SAI object, to look at. */
  Node peek(X3DNode node) {
    return find(node).node();
  }

  /** What stands behind an SAI object. */
  NodeProxy proxyOf(X3DNode node) {
    check();
    return find(node);
  }

  private NodeProxy find(@Nullable X3DNode node) {
    InvocationHandler handler =
        node != null && Proxy.isProxyClass(node.getClass())
            ? Proxy.getInvocationHandler(node)
            : null;
    if (handler instanceof NodeProxy proxy && proxy.binding() == this) {
      return proxy;
    }
    throw new InvalidNodeException(
        node == null ? "a node is needed, not null" : "the node is of another browser");
  }

  /** Does a change now, or at the end of the update that this thread has begun. */
  void execute(Runnable change) {
    check();
    if (!updates.hold(change)) {
      world.execute(change);
    }
  }

  /** Sends a value, within a change that is being done. */
  void sendNow(Node node, int field, @Nullable Object value) {
    world.cascade().send(node, field, value);
  }

  void beginUpdate() {
    check();
    updates.begin();
  }

  void endUpdate() {
    check();
    UpdateBuffer.Held held = updates.end();
    if (!held.isEmpty()) {
      world.execute(held);
    }
  }
}
