package org.selectiverenderer.runtime.render;

import java.util.Optional;
import org.selectiverenderer.runtime.LayerView;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.camera.DepthRange;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.nodes.bind.ViewpointNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.viewer.Viewer;
import org.selectiverenderer.runtime.walk.Navigation;

/**
 * What the bound NavigationInfo decides about a picture (X3D 4.0, 23.4.4), and the bound
 * viewpoint's {@code nearDistance} and {@code farDistance} where they are above 0 and nothing is to
 * be seen beyond them: not with {@code viewAll} (23.3.1).
 *
 * @param range of depths that are drawn
 * @param headlight whether the viewer carries a light
 */
public record VisibleRange(DepthRange range, boolean headlight) {
  public static VisibleRange of(World world) {
    return of(
        world.instances(),
        world.viewer(),
        world.bindables().bound("NavigationInfo"),
        world.bindables().bound("X3DViewpointNode"));
  }

  /** That of one of a world's layers. */
  public static VisibleRange of(LayerView layer) {
    return of(layer.instances(), layer.viewer(), layer.navigationInfo(), layer.viewpoint());
  }

  private static VisibleRange of(
      InstanceTree tree,
      Viewer viewer,
      Optional<? extends Node> info,
      Optional<? extends Node> viewpoint) {
    DepthRange range =
        DepthRange.of(
            tree,
            viewer.position(),
            info.map(Navigation::of).orElse(Navigation.WALKING).radius(),
            info.map(node -> (double) node.number("visibilityLimit")).orElse(0.0));
    double near = distance(viewpoint, "nearDistance").orElse(range.near());
    double far = distance(viewpoint, "farDistance").orElse(Math.max(range.far(), 2 * near));
    return new VisibleRange(
        new DepthRange(near < far ? near : far / 2, far),
        info.map(node -> node.bool("headlight")).orElse(true));
  }

  private static Optional<Double> distance(Optional<? extends Node> viewpoint, String field) {
    return viewpoint
        .filter(node -> !(node instanceof ViewpointNode known && known.viewAll()))
        .map(node -> node.value(field) instanceof Float f ? (double) f : -1)
        .filter(distance -> distance > 0);
  }
}
