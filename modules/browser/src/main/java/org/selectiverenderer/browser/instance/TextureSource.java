package org.selectiverenderer.browser.instance;

import org.jspecify.annotations.Nullable;

/**
 * The image source of a texture with its sampler settings; reading the same node again gives an
 * equal value.
 */
public sealed interface TextureSource
    permits Texture, CubeTexture, GeneratedCubeTexture, VolumeTexture {
  /** Returns the settings of the TextureProperties node, or null. */
  @Nullable TextureSampler sampling();

  /**
   * Returns the number of colour components as X3D counts them (18.2.1): 1 or 2 for grey, 3 or 4
   * for colour.
   */
  int components();

  /** Returns whether this is a cube map, which is sampled by direction. */
  default boolean cube() {
    return false;
  }
}
