package org.selectiverenderer.runtime.render;

import java.util.Optional;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.camera.DepthRange;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.walk.Navigation;

/**
 * What the bound NavigationInfo decides about a picture (X3D 4.0, 23.4.4), and the bound
 * viewpoint's {@code nearDistance} and {@code farDistance} where they are above 0 (23.3.1).
 *
 * @param range of depths that are drawn
 * @param headlight whether the viewer carries a light
 */
public record VisibleRange(DepthRange range, boolean headlight) {
  public static VisibleRange of(World world) {
    Optional<Node> info = world.bindables().bound("NavigationInfo");
    DepthRange range =
        DepthRange.of(
            world.instances(),
            world.viewer().position(),
            info.map(Navigation::of).orElse(Navigation.WALKING).radius(),
            info.map(node -> (double) node.number("visibilityLimit")).orElse(0.0));
    double near = distance(world, "nearDistance").orElse(range.near());
    double far = distance(world, "farDistance").orElse(Math.max(range.far(), 2 * near));
    return new VisibleRange(
        new DepthRange(near < far ? near : far / 2, far),
        info.map(node -> node.bool("headlight")).orElse(true));
  }

  private static Optional<Double> distance(World world, String field) {
    return world
        .bindables()
        .bound("X3DViewpointNode")
        .map(viewpoint -> viewpoint.value(field) instanceof Float f ? (double) f : -1)
        .filter(distance -> distance > 0);
  }
}
