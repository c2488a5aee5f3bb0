package org.selectiverenderer.runtime.render;

import java.util.Optional;

/**
 * How a scene is drawn, beside what the scene says.
 *
 * @param shading where light is computed
 * @param headlight whether the viewer carries a light; empty for what the bound NavigationInfo says
 * @param wireframe whether only the edges of polygons are drawn, also of those behind others
 */
public record DrawStyle(Shading shading, Optional<Boolean> headlight, boolean wireframe) {
  /** As the scene says. */
  public static DrawStyle of(Shading shading) {
    return new DrawStyle(shading, Optional.empty(), false);
  }
}
