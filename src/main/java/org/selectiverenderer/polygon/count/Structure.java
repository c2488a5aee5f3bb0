package org.selectiverenderer.polygon.count;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.geometry.tessellate.NodeContent;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Which nodes of a file hold what is drawn: the same that the embedded browser draws. */
final class Structure {
  private Structure() {}

  /** Whether nodes of a type hold others that are drawn. */
  static boolean isGroup(NodeType type) {
    return NodeContent.isGroup(type) || type.name().equals("Inline");
  }

  static boolean isInline(ParsedNode node) {
    return node.type().name().equals("Inline");
  }

  static boolean isShape(ParsedNode node) {
    return node.type().name().equals("Shape") || isInstanced(node);
  }

  /** Whether a shape has one geometry in many places. */
  static boolean isInstanced(ParsedNode shape) {
    return shape.type().name().equals("InstancedShape");
  }

  static boolean isSwitch(ParsedNode node) {
    return node.type().name().equals("Switch");
  }

  static boolean isSensor(ParsedNode node) {
    return node.type().name().equals("ProximitySensor");
  }

  /** The nodes in a group of the same file, shown or not; none for what is no group. */
  static List<ParsedNode> children(ParsedNode node) {
    return NodeContent.of(node).stream().map(ParsedNode.class::cast).toList();
  }

  static Optional<ParsedNode> geometry(ParsedNode shape) {
    return Optional.ofNullable((ParsedNode) shape.node("geometry"));
  }

  /** The field {@code visible} (X3D 4.0); true for what has none. */
  static boolean visible(ParsedNode node) {
    return node.type().field("visible").map(f -> (Boolean) node.value(f.index())).orElse(true);
  }
}
