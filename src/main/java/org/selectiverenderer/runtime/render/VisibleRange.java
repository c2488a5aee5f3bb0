package org.selectiverenderer.runtime.render;

import java.util.Optional;
import org.selectiverenderer.runtime.LayerView;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.camera.DepthRange;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.viewer.Viewer;
import org.selectiverenderer.runtime.walk.Navigation;

/**
 * What the bound NavigationInfo decides about a picture (X3D 4.0, 23.4.4).
 *
 * @param range of depths that are drawn
 * @param headlight whether the viewer carries a light
 */
public record VisibleRange(DepthRange range, boolean headlight) {
  public static VisibleRange of(World world) {
    return of(world.instances(), world.viewer(), world.bindables().bound("NavigationInfo"));
  }

  /** That of one of a world's layers. */
  public static VisibleRange of(LayerView layer) {
    return of(layer.instances(), layer.viewer(), layer.navigationInfo());
  }

  private static VisibleRange of(InstanceTree tree, Viewer viewer, Optional<Node> info) {
    DepthRange range =
        DepthRange.of(
            tree,
            viewer.position(),
            info.map(Navigation::of).orElse(Navigation.WALKING).radius(),
            info.map(node -> (double) node.number("visibilityLimit")).orElse(0.0));
    return new VisibleRange(range, info.map(node -> node.bool("headlight")).orElse(true));
  }
}
