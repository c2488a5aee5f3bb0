package org.selectiverenderer.browser.loading;

import org.selectiverenderer.formats.image.Srgb;

/**
 * Converts linear light of any brightness to the sRGB bytes of a texture. A colour whose largest
 * channel m is at most 0.8 stays as it is; above, all its channels are scaled so that m becomes 1 -
 * 0.04 / (m - 0.6), which approaches 1 and keeps the hue. This is the compression of highlights of
 * the Khronos PBR Neutral tone mapper (2024), without its desaturation.
 */
final class ToneMapper {
  private static final float START = 0.8f;

  /** The steps of the table between 0 and 1; the darkest differ by less than one byte value. */
  private static final int STEPS = 1 << 14;

  private final byte[] encoded = new byte[STEPS + 1];

  ToneMapper() {
    for (int i = 0; i <= STEPS; i++) {
      encoded[i] = (byte) Math.round(255 * Srgb.display((double) i / STEPS));
    }
  }

  /**
   * Writes a colour as three bytes.
   *
   * @param red linear light; a value that is negative or no number counts as 0
   */
  void write(float red, float green, float blue, byte[] rgba, int to) {
    float most = Math.max(valid(red), Math.max(valid(green), valid(blue)));
    float scale = 1;
    if (most > START) {
      float shown = 1 - (1 - START) * (1 - START) / (most - START + 1 - START);
      scale = shown / most;
    }
    rgba[to] = encoded[Math.round(valid(red) * scale * STEPS)];
    rgba[to + 1] = encoded[Math.round(valid(green) * scale * STEPS)];
    rgba[to + 2] = encoded[Math.round(valid(blue) * scale * STEPS)];
  }

  private static float valid(float value) {
    return value > 0 ? Math.min(value, 1e30f) : 0;
  }
}
