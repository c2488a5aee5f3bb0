package org.selectiverenderer.browser.instance;

import org.jspecify.annotations.Nullable;

/**
 * A three-dimensional texture (X3D 4.0, clause 33).
 *
 * @param image the image whose layers are the slices, the first at r = 0
 */
public record VolumeTexture(
    Texture.Image image,
    boolean repeatS,
    boolean repeatT,
    boolean repeatR,
    @Nullable TextureSampler sampling)
    implements TextureSource {
  @Override
  public int components() {
    return image.components();
  }
}
