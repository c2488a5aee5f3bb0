package org.selectiverenderer.runtime.render.draw;

import java.util.Optional;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.Fog;

/**
 * What shapes are seen in.
 *
 * @param backdrop behind them; empty where what is drawn already is to be seen
 * @param headlight whether the viewer carries a light
 * @param fog where no LocalFog reaches
 * @param over whether there is a picture below, which a transparent backdrop lets through
 */
public record Setting(Optional<Backdrop> backdrop, boolean headlight, Fog fog, boolean over) {}
