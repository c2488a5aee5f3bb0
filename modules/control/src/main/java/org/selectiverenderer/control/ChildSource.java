package org.selectiverenderer.control;

import java.util.List;
import org.web3d.x3d.sai.X3DNode;

/**
 * A source of child nodes of a node: a field or the scene of an Inline. It is observed for changes.
 */
abstract class ChildSource {
  /** Receives changes of the child nodes. */
  @FunctionalInterface
  interface Listener {
    void changed(SceneScope scope, List<X3DNode> before, List<X3DNode> after, double time);
  }

  private final Listener listener;
  private List<X3DNode> children = List.of();

  ChildSource(Listener listener) {
    this.listener = listener;
  }

  /** Reads the child nodes and begins to listen for changes. */
  final void open() {
    children = look();
    listen();
  }

  /** Returns the child nodes as last read. */
  final List<X3DNode> children() {
    return children;
  }

  /** Reads the child nodes anew and tells the listener. */
  final void changed(double time) {
    List<X3DNode> before = children;
    children = look();
    listener.changed(scope(), before, children, time);
  }

  /** Returns the scene that contains the child nodes. */
  abstract SceneScope scope();

  /** Reads the present child nodes. */
  abstract List<X3DNode> look();

  abstract void listen();

  /** Stops listening. */
  abstract void close();
}
