package org.selectiverenderer.render;

import java.util.Optional;

/**
 * Options for drawing a scene that the scene itself does not set.
 *
 * @param shading where light is computed
 * @param headlight whether the viewer carries a headlight; empty to follow the bound NavigationInfo
 * @param wireframe whether only the edges of polygons are drawn, including hidden polygons
 */
public record RenderOptions(ShadingMode shading, Optional<Boolean> headlight, boolean wireframe) {
  /** Returns options that leave headlight and polygon mode to the scene. */
  public static RenderOptions of(ShadingMode shading) {
    return new RenderOptions(shading, Optional.empty(), false);
  }
}
