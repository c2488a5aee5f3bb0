package org.selectiverenderer.browser.instance;

/**
 * The sampler settings of a texture: a TextureProperties node (X3D 4.0, 18.4.9).
 *
 * @param s the boundary mode in the direction of s; {@code t} and {@code r} likewise
 * @param border the border colour for the boundary mode {@code BORDER}
 * @param anisotropy the degree of anisotropic filtering, at least 1
 */
public record TextureSampler(
    Boundary s,
    Boundary t,
    Boundary r,
    Color border,
    float anisotropy,
    Minify minify,
    boolean magnifyLinear) {

  /** A colour with its opacity, each 0..1. */
  public record Color(float r, float g, float b, float a) {}

  /** The boundary mode: how texture coordinates beyond the edge of an image are treated. */
  public enum Boundary {
    REPEAT,
    MIRROR,
    EDGE,
    BORDER
  }

  /** The minification filter; the second part of a name is the filter between mipmap levels. */
  public enum Minify {
    NEAREST,
    LINEAR,
    NEAREST_NEAREST,
    NEAREST_LINEAR,
    LINEAR_NEAREST,
    LINEAR_LINEAR;

    /** Returns whether the filter uses mipmaps. */
    public boolean mipmaps() {
      return ordinal() > LINEAR.ordinal();
    }
  }
}
