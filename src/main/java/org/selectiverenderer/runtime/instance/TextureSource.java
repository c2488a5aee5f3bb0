package org.selectiverenderer.runtime.instance;

import org.jspecify.annotations.Nullable;

/** What a texture's colours come from, with its sampling; a value, however often it is read. */
public sealed interface TextureSource permits Texture, CubeTexture, GeneratedCube, VolumeTexture {
  /** What TextureProperties says of it, or null. */
  @Nullable Sampling sampling();

  /** Colour components as X3D counts them (18.2.1): 1 or 2 grey, 3 or 4 coloured. */
  int components();

  /** Whether it is looked up by directions. */
  default boolean cube() {
    return false;
  }
}
