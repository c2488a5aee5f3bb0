package org.selectiverenderer.radiosity.scene;

import org.selectiverenderer.formats.image.Srgb;

/**
 * Conversions between X3D's colours and photometric quantities.
 *
 * <p>X3D has no units of light: a surface of {@code emissiveColor} 1 is drawn as white as a white
 * surface at right angles to a light of {@code intensity} 1. Both are taken as a luminance of
 * {@link #WHITE}. Colours are encoded for the display (IEC 61966-2-1, sRGB) and are decoded to
 * linear light.
 */
public final class Photometry {
  /** Luminance of display white, cd/m2. */
  public static final double WHITE = 250;

  private Photometry() {}

  /** Decodes a display value to linear light, 0 .. 1 to 0 .. 1 (IEC 61966-2-1). */
  public static float linear(double display) {
    return (float) Srgb.light(Math.max(0, Math.min(1, display)));
  }

  /** Encodes linear light for the display, the inverse of {@link #linear}. */
  public static double display(double linear) {
    return Srgb.display(Math.max(0, Math.min(1, linear)));
  }

  public static float[] linear(float[] rgb) {
    return new float[] {linear(rgb[0]), linear(rgb[1]), linear(rgb[2])};
  }

  /** Returns the luminance of linear red, green and blue (ITU-R BT.709). */
  public static double luminance(double r, double g, double b) {
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  }

  public static double luminance(float[] rgb) {
    return luminance(rgb[0], rgb[1], rgb[2]);
  }
}
