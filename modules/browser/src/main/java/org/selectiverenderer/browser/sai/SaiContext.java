package org.selectiverenderer.browser.sai;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.web3d.x3d.sai.InvalidBrowserException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.X3DNode;

/**
 * The context that the SAI objects of one browser share: it maps nodes to SAI objects, passes
 * writes to the world, and knows whether the browser was disposed of. Thread-safe.
 */
final class SaiContext {
  private final World world;
  private final SaiTypeRegistry types = new SaiTypeRegistry();
  private final SaiValueConverter values = new SaiValueConverter(this);
  private final UpdateBuffer updates = new UpdateBuffer();
  private volatile boolean disposed;

  SaiContext(World world) {
    this.world = world;
  }

  SaiTypeRegistry types() {
    return types;
  }

  SaiValueConverter values() {
    return values;
  }

  ProblemCollector problems() {
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
   * Returns the SAI object of a node, always the same; for a prototype instance that of its
   * interface. Null for null.
   */
  @Nullable X3DNode wrap(@Nullable Node node) {
    return node == null ? null : proxy(PrototypeInstance.seen(node, null), true).proxy();
  }

  /** Returns the SAI object of a node that is not null. */
  X3DNode wrapped(Node node) {
    return exactly(PrototypeInstance.seen(node, null));
  }

  /** Returns the SAI object of the node itself, as seen within the body of a prototype. */
  X3DNode exactly(Node node) {
    check();
    return proxy(node, true).proxy();
  }

  /** Returns the SAI object of a node itself, if it has one already. */
  Optional<X3DNode> known(Node node) {
    synchronized (node) {
      return node.companion() instanceof NodeProxy known && known.binding() == this
          ? Optional.of(known.proxy())
          : Optional.empty();
    }
  }

  /**
   * Returns the SAI object of a new node, whose initializeOnly fields the application may set until
   * it is realized.
   */
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

  /** Returns the scene's node of an SAI object and marks it as realized; null for null. */
  @Nullable Node unwrap(@Nullable X3DNode node) {
    return node == null ? null : body(node);
  }

  /**
   * Returns the scene's node of an SAI object: of a prototype instance, the first node of its body.
   */
  Node body(X3DNode node) {
    return PrototypeInstance.body(unwrapped(node));
  }

  /**
   * Returns the node or prototype interface of an SAI object and marks it as realized.
   *
   * @throws InvalidNodeException if it belongs to another browser or was disposed of
   */
  Node unwrapped(@Nullable X3DNode node) {
    NodeProxy proxy = find(node);
    proxy.check();
    proxy.realize();
    return proxy.node();
  }

  /** Returns the node of an SAI object without marking it as realized. */
  Node peek(X3DNode node) {
    return find(node).node();
  }

  /** Returns the invocation handler of an SAI object. */
  NodeProxy proxyOf(X3DNode node) {
    check();
    return find(node);
  }

  /** Returns the node itself of an SAI object of this browser; empty for any other object. */
  Optional<Node> own(X3DNode node) {
    return node instanceof SaiObject object
            && object.handler() instanceof NodeProxy proxy
            && proxy.binding() == this
        ? Optional.of(proxy.node())
        : Optional.empty();
  }

  private NodeProxy find(@Nullable X3DNode node) {
    if (node instanceof SaiObject object
        && object.handler() instanceof NodeProxy proxy
        && proxy.binding() == this) {
      return proxy;
    }
    throw new InvalidNodeException(
        node == null ? "a node is needed, not null" : "the node belongs to another browser");
  }

  /** Executes a change now, or at the end of the update bracket that this thread has opened. */
  void execute(Runnable change) {
    check();
    if (!updates.hold(change)) {
      world.execute(change);
    }
  }

  /** Sends a value to a field, during a change. */
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
