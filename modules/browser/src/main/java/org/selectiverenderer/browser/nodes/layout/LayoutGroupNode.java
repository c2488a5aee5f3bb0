package org.selectiverenderer.browser.nodes.layout;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * LayoutGroup and LayoutLayer: groups whose content lies in a rectangle that is measured relative
 * to the parent rectangle or, without a parent, to the whole picture (X3D 4.0, 36.4.1 to 36.4.3).
 * The rectangle's centre is the origin of the content. The outermost rectangle is placed in front
 * of the viewer and moves along. Depths are scaled by the smaller of the scales of width and
 * height, so that solids keep their proportions. Without a {@code layout} the node is an ordinary
 * group.
 */
public final class LayoutGroupNode extends GroupingNode implements ViewDependentLayout {
  public LayoutGroupNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
  }

  @Override
  public Spot spot(Matrix4dc world, ViewParameters sight, Optional<LayoutRectangle> above) {
    Node layout = node("layout");
    if (layout == null || !layout.type().name().equals("Layout")) {
      return new Spot(world, Optional.empty());
    }
    LayoutRectangle outer =
        above.orElseGet(() -> new LayoutRectangle(sight.width(), sight.height()));
    Vector3d units =
        above.isPresent() ? world.getScale(new Vector3d()) : new Vector3d(); // No parent: 0.
    LayoutAxis across =
        LayoutAxis.of(
            layout,
            0,
            new LayoutAxis.Measure(outer.width(), sight.width() / sight.pixelsWide(), units.x));
    LayoutAxis up =
        LayoutAxis.of(
            layout,
            1,
            new LayoutAxis.Measure(outer.height(), sight.height() / sight.pixelsHigh(), units.y));
    double both = Math.max(across.size(), up.size()); // Used if both are STRETCH.
    double x = across.scale() != 0 ? across.scale() : up.scale() != 0 ? up.scale() : both;
    double y = up.scale() != 0 ? up.scale() : x;
    Matrix4d content =
        (above.isPresent() ? unscaled(world) : sight.frame())
            .translate(across.middle(), up.middle(), 0)
            .scale(x, y, Math.min(Math.abs(x), Math.abs(y)));
    return new Spot(content, Optional.of(new LayoutRectangle(across.size(), up.size())));
  }

  /** Returns the translation and rotation of a matrix, without its scale. */
  private static Matrix4d unscaled(Matrix4dc world) {
    Vector3d size = world.getScale(new Vector3d());
    return size.x == 0 || size.y == 0 || size.z == 0
        ? new Matrix4d(world)
        : world.scale(1 / size.x, 1 / size.y, 1 / size.z, new Matrix4d());
  }
}
