package org.selectiverenderer.browser.nodes.event;

/**
 * Converts colours between RGB and HSV; hue is in 0..6 from red over green and blue, saturation and
 * value are in 0..1.
 */
final class HsvColor {
  private HsvColor() {}

  /** Converts r, g, b at an offset to HSV. The hue of a grey is 0. */
  static void of(float[] rgb, int offset, float[] into) {
    float r = rgb[offset];
    float g = rgb[offset + 1];
    float b = rgb[offset + 2];
    float max = Math.max(r, Math.max(g, b));
    float range = max - Math.min(r, Math.min(g, b));
    into[1] = max > 0 ? range / max : 0;
    into[2] = max;
    if (range == 0) {
      into[0] = 0;
    } else if (max == r) {
      into[0] = (g - b) / range + (g < b ? 6 : 0);
    } else {
      into[0] = max == g ? 2 + (b - r) / range : 4 + (r - g) / range;
    }
  }

  /** Converts HSV to r, g, b; the hue may be outside 0..6. */
  static void rgb(float hue, float saturation, float value, float[] into, int offset) {
    for (int i = 0; i < 3; i++) {
      float from = hue - 2 * i; // from red, green, blue
      float opposite = Math.abs(from - 6 * (float) Math.floor(from / 6) - 3);
      float pure = Math.max(0, Math.min(1, opposite - 1));
      into[offset + i] = value * (1 - saturation * (1 - pure));
    }
  }
}
