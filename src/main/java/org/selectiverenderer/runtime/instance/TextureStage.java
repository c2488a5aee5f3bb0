package org.selectiverenderer.runtime.instance;

/**
 * How a texture of a MultiTexture is blended with what is there (X3D 4.0, 18.4.3).
 *
 * @param mode of the colour, such as {@code MODULATE}
 * @param alphaMode of the opacity
 * @param source what is there: "" the stage before, else {@code DIFFUSE}, {@code SPECULAR} or
 *     {@code FACTOR}
 * @param function applied to the result: "", {@code COMPLEMENT} or {@code ALPHAREPLICATE}
 */
public record TextureStage(String mode, String alphaMode, String source, String function) {}
