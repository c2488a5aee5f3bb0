package org.selectiverenderer.control;

import java.util.HashMap;
import java.util.Map;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;

/**
 * Names of nodes for events and messages: the DEF name, else one made up of the type and the place
 * among the nodes of that type in the scene ({@code Switch#3}), which a node keeps. The SAI does
 * not tell a node's name, only the node of a name, so that nodes are compared: a browser may hand
 * out the same object for a node each time, or an equal one. All names are looked up for that, so
 * only when a name is asked for.
 */
final class NodeNames {
  private final X3DExecutionContext scene;
  private final Map<X3DNode, String> names = new HashMap<>();
  private final Map<X3DNode, String> unnamed = new HashMap<>();
  private final Map<String, Integer> numbers = new HashMap<>();

  NodeNames(X3DExecutionContext scene) {
    this.scene = scene;
  }

  /** Names nodes that appeared, in the order of the scene. */
  void add(Iterable<X3DNode> nodes) {
    for (X3DNode node : nodes) {
      String type = node.getNodeName();
      unnamed.put(node, type + "#" + numbers.merge(type, 1, Integer::sum));
    }
  }

  private void look() {
    for (String name : scene.getNamedNodes()) {
      X3DNode node = scene.getNamedNode(name);
      if (unnamed.remove(node) != null) {
        names.put(node, name.strip());
      }
    }
    names.putAll(unnamed);
    unnamed.clear();
  }

  void remove(X3DNode node) {
    names.remove(node);
    unnamed.remove(node);
  }

  /** The name of a node that was added. */
  String of(X3DNode node) {
    if (unnamed.containsKey(node)) {
      look();
    }
    String name = names.get(node);
    if (name == null) {
      throw new IllegalArgumentException("no name was requested for " + node.getNodeName());
    }
    return name;
  }
}
