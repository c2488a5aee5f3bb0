package org.selectiverenderer.render.draw;

import java.util.Optional;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.Fog;

/**
 * The background, headlight and fog that a scene is drawn with.
 *
 * @param backdrop the background; empty where the layer below is to be seen
 * @param headlight whether the viewer carries a headlight
 * @param fog the bound fog, which counts where no LocalFog reaches
 * @param over whether a lower layer is drawn already, which a transparent background lets through
 */
public record LightingContext(
    Optional<Background> backdrop, boolean headlight, Fog fog, boolean over) {}
