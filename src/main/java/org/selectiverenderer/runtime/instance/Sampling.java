package org.selectiverenderer.runtime.instance;

/**
 * How a texture is sampled: TextureProperties (X3D 4.0, 18.4.9).
 *
 * @param s what lies beyond the edge in the direction of s; {@code t} and {@code r} likewise
 * @param border r, g, b, a that lies there where a boundary mode says so
 * @param anisotropy samples per pixel of a slanted face, from 1
 */
public record Sampling(
    Boundary s,
    Boundary t,
    Boundary r,
    Color border,
    float anisotropy,
    Minify minify,
    boolean magnifyLinear) {

  /** A colour with its opacity, each 0..1. */
  public record Color(float r, float g, float b, float a) {}

  /** What lies beyond the edge of an image. */
  public enum Boundary {
    REPEAT,
    MIRROR,
    EDGE,
    BORDER
  }

  /** How pixels that cover much of an image are made; the second part of a name is of mipmaps. */
  public enum Minify {
    NEAREST,
    LINEAR,
    NEAREST_NEAREST,
    NEAREST_LINEAR,
    LINEAR_NEAREST,
    LINEAR_LINEAR;

    /** Whether there are smaller versions to choose from. */
    public boolean mipmaps() {
      return ordinal() > LINEAR.ordinal();
    }
  }
}
