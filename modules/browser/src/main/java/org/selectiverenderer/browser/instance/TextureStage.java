package org.selectiverenderer.browser.instance;

/**
 * The blending stage of a MultiTexture: how a texture is combined with its input (X3D 4.0, 18.4.3).
 *
 * @param mode the blending mode of the colour, such as {@code MODULATE}
 * @param alphaMode the blending mode of the opacity
 * @param source the second input: "" for the previous stage, else {@code DIFFUSE}, {@code SPECULAR}
 *     or {@code FACTOR}
 * @param function the function applied to the result: "", {@code COMPLEMENT} or {@code
 *     ALPHAREPLICATE}
 */
public record TextureStage(String mode, String alphaMode, String source, String function) {}
