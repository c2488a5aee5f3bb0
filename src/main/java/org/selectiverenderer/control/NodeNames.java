package org.selectiverenderer.control;

import java.util.HashMap;
import java.util.Map;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;

/**
 * Names of nodes for events and messages: the DEF name, else one made up of the type and the place
 * among the nodes of that type in the scene ({@code Switch#3}), which a node keeps. The SAI does
 * not tell a node's name, only the node of a name, so that nodes are compared: a browser may hand
 * out the same object for a node each time, or an equal one.
 */
final class NodeNames {
  private final X3DExecutionContext scene;
  private final Map<X3DNode, String> names = new HashMap<>();
  private final Map<String, Integer> numbers = new HashMap<>();

  NodeNames(X3DExecutionContext scene) {
    this.scene = scene;
  }

  /** Names nodes that appeared, in the order of the scene. */
  void add(Iterable<X3DNode> nodes) {
    Map<X3DNode, String> defined = new HashMap<>();
    for (String name : scene.getNamedNodes()) {
      defined.put(scene.getNamedNode(name), name);
    }
    for (X3DNode node : nodes) {
      String type = node.getNodeName();
      int number = numbers.merge(type, 1, Integer::sum);
      String name = defined.get(node);
      names.put(node, name != null ? name.strip() : type + "#" + number);
    }
  }

  void remove(X3DNode node) {
    names.remove(node);
  }

  /** The name of a node that was added. */
  String of(X3DNode node) {
    String name = names.get(node);
    if (name == null) {
      throw new IllegalArgumentException("no name was asked for " + node.getNodeName());
    }
    return name;
  }
}
