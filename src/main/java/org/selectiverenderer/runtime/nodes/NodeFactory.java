package org.selectiverenderer.runtime.nodes;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeType;

/** Makes the node for a node type: the class with its behaviour where there is one. */
public final class NodeFactory {
  /** Makes a node of a type. */
  @FunctionalInterface
  public interface Maker {
    Node make(NodeType type, @Nullable String name, Location location);
  }

  private final Map<String, Maker> makers = new HashMap<>();

  public NodeFactory() {
    for (String group : Set.of("Group", "StaticGroup", "Anchor")) {
      makers.put(group, GroupingNode::new);
    }
    makers.put("Transform", TransformNode::new);
    makers.put("Switch", SwitchNode::new);
    makers.put("LOD", LodNode::new);
    makers.put("Billboard", BillboardNode::new);
    makers.put("Collision", CollisionNode::new);
    makers.put("Inline", InlineNode::new);
  }

  /** A node with all fields at their defaults. */
  public Node make(NodeType type, @Nullable String name, Location location) {
    return makers.getOrDefault(type.name(), Node::new).make(type, name, location);
  }
}
