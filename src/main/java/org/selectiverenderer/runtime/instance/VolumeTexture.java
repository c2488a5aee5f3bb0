package org.selectiverenderer.runtime.instance;

import org.jspecify.annotations.Nullable;

/**
 * A texture of three dimensions (X3D 4.0, 33).
 *
 * @param image whose layers are its slices, the first at r = 0
 */
public record VolumeTexture(
    Texture.Image image,
    boolean repeatS,
    boolean repeatT,
    boolean repeatR,
    @Nullable Sampling sampling)
    implements TextureSource {
  @Override
  public int components() {
    return image.components();
  }
}
