package org.selectiverenderer.browser.nodes.group;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.tessellate.GroupingNodeChildren;

/**
 * CollidableShape and CollidableOffset: place the shape or the collidable that they hold (X3D 4.0,
 * 37.3.2). Rigid body physics is not supported; the nodes are only drawn if they are children of a
 * group.
 */
public final class CollidableNode extends GroupingNode {
  private final int held;
  private final int translation;
  private final int rotation;

  public CollidableNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    held = type.indexOf(type.name().equals("CollidableShape") ? "shape" : "collidable");
    translation = type.indexOf("translation");
    rotation = type.indexOf("rotation");
  }

  @Override
  public List<Node> children() {
    return value(held) instanceof Node node ? List.of(node) : List.of();
  }

  @Override
  public Optional<Matrix4d> placement() {
    return GroupingNodeChildren.placement(this);
  }

  @Override
  public Effect effectOf(int field) {
    if (field == held) {
      return Effect.STRUCTURE;
    }
    return field == translation || field == rotation ? Effect.PLACEMENT : super.effectOf(field);
  }
}
