package org.selectiverenderer.control;

import java.util.List;
import org.web3d.x3d.sai.X3DNode;

/** What leads from a node to others, and is followed as it changes. */
abstract class Branch {
  /** Hears that a branch leads to other nodes. */
  @FunctionalInterface
  interface Listener {
    void changed(SceneScope scope, List<X3DNode> before, List<X3DNode> after, double time);
  }

  private final Listener listener;
  private List<X3DNode> children = List.of();

  Branch(Listener listener) {
    this.listener = listener;
  }

  /** Reads where it leads and begins to follow it. */
  final void open() {
    children = look();
    listen();
  }

  /** The nodes that it leads to. */
  final List<X3DNode> children() {
    return children;
  }

  /** It leads elsewhere. */
  final void changed(double time) {
    List<X3DNode> before = children;
    children = look();
    listener.changed(scope(), before, children, time);
  }

  /** The scene in which the nodes stand. */
  abstract SceneScope scope();

  /** The nodes that it leads to now. */
  abstract List<X3DNode> look();

  abstract void listen();

  /** Ends the following. */
  abstract void close();
}
