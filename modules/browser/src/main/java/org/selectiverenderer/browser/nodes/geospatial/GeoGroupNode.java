package org.selectiverenderer.browser.nodes.geospatial;

import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.tessellate.GroupingNodeChildren;

/**
 * GeoLocation and GeoTransform (X3D 4.0, 25.3.7, 25.3.11): grouping nodes that place their children
 * on the earth.
 */
final class GeoGroupNode extends GroupingNode {
  private static final Set<String> PLACING =
      Set.of("geoCoords", "geoCenter", "translation", "rotation", "scale", "scaleOrientation");

  GeoGroupNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
  }

  @Override
  public Optional<Matrix4d> placement() {
    return GroupingNodeChildren.placement(this);
  }

  @Override
  public Effect effectOf(int field) {
    return PLACING.contains(type().fields().get(field).name())
        ? Effect.PLACEMENT
        : super.effectOf(field);
  }
}
