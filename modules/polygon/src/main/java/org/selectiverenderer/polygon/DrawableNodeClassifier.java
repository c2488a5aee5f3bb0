package org.selectiverenderer.polygon;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.tessellate.GroupingNodeChildren;

/**
 * Classifies the nodes of a file that are drawn or contain drawn nodes, in agreement with the
 * embedded browser.
 */
final class DrawableNodeClassifier {
  private DrawableNodeClassifier() {}

  /** Returns whether nodes of a type can contain drawn nodes. */
  static boolean isGroup(NodeType type) {
    return GroupingNodeChildren.isGroup(type) || type.name().equals("Inline");
  }

  static boolean isInline(ParsedNode node) {
    return node.type().name().equals("Inline");
  }

  static boolean isShape(ParsedNode node) {
    return node.type().name().equals("Shape") || isInstanced(node);
  }

  /** Returns whether a shape draws many instances of one geometry. */
  static boolean isInstanced(ParsedNode shape) {
    return shape.type().name().equals("InstancedShape");
  }

  static boolean isSwitch(ParsedNode node) {
    return node.type().name().equals("Switch");
  }

  static boolean isSensor(ParsedNode node) {
    return node.type().name().equals("ProximitySensor");
  }

  /**
   * Returns the children of a group in the same file, shown or not; empty for a node that is not a
   * group.
   */
  static List<ParsedNode> children(ParsedNode node) {
    return GroupingNodeChildren.of(node).stream().map(ParsedNode.class::cast).toList();
  }

  static Optional<ParsedNode> geometry(ParsedNode shape) {
    return Optional.ofNullable((ParsedNode) shape.node("geometry"));
  }

  /** Returns the field {@code visible} (X3D 4.0); true for nodes without it. */
  static boolean visible(ParsedNode node) {
    return node.type().field("visible").map(f -> (Boolean) node.value(f.index())).orElse(true);
  }
}
