package org.selectiverenderer.render;

import java.util.Optional;
import org.selectiverenderer.browser.LayerView;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.navigation.NavigationParameters;
import org.selectiverenderer.browser.nodes.bindable.ViewpointNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.Viewer;

/**
 * The depth range and headlight of a view, from the bound NavigationInfo (X3D 4.0, 23.4.4) and the
 * bound viewpoint's {@code nearDistance} and {@code farDistance}. The distances count where they
 * are above 0 and the viewpoint does not set {@code viewAll} (23.3.1).
 *
 * @param range the depths between the near and the far clipping plane
 * @param headlight whether the viewer carries a headlight
 */
public record ViewSettings(DepthRange range, boolean headlight) {
  public static ViewSettings of(World world) {
    ViewSettings scenes =
        of(
            world.instances(),
            world.viewer(),
            world.bindables().bound("NavigationInfo"),
            world.bindables().bound("X3DViewpointNode"));
    return new ViewSettings(scenes.range, world.headlight().orElse(scenes.headlight));
  }

  /** Returns the settings of one of a world's layers. */
  public static ViewSettings of(LayerView layer) {
    return of(layer.instances(), layer.viewer(), layer.navigationInfo(), layer.viewpoint());
  }

  private static ViewSettings of(
      InstanceTree tree,
      Viewer viewer,
      Optional<? extends Node> info,
      Optional<? extends Node> viewpoint) {
    DepthRange range =
        DepthRange.of(
            tree,
            viewer.position(),
            info.map(NavigationParameters::of).orElse(NavigationParameters.WALKING).radius(),
            info.map(node -> (double) node.number("visibilityLimit")).orElse(0.0),
            viewpoint.filter(ViewSettings::viewsAll).isPresent());
    double near = distance(viewpoint, "nearDistance").orElse(range.near());
    double far = distance(viewpoint, "farDistance").orElse(Math.max(range.far(), 2 * near));
    return new ViewSettings(
        new DepthRange(near < far ? near : far / 2, far),
        info.map(node -> node.bool("headlight")).orElse(true));
  }

  private static boolean viewsAll(Node node) {
    return node instanceof ViewpointNode known && known.viewAll();
  }

  private static Optional<Double> distance(Optional<? extends Node> viewpoint, String field) {
    return viewpoint
        .filter(node -> !viewsAll(node))
        .map(node -> node.value(field) instanceof Float f ? (double) f : -1)
        .filter(distance -> distance > 0);
  }
}
