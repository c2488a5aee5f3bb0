package org.selectiverenderer.browser.nodes.layout;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * ScreenGroup: a group in which one unit is one pixel at any distance from the viewer (X3D 4.0,
 * 36.4.5).
 */
final class ScreenGroupNode extends GroupingNode implements ViewDependentLayout {
  ScreenGroupNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
  }

  @Override
  public Spot spot(Matrix4dc world, ViewParameters sight, Optional<LayoutRectangle> above) {
    return new Spot(world.scale(sight.pixelScale(world), new Matrix4d()), Optional.empty());
  }
}
