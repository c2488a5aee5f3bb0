package org.selectiverenderer.base.picture;

/** Between what a display is told and the light that it shows (IEC 61966-2-1, sRGB). */
public final class Srgb {

  private Srgb() {}

  /** The share of light of a display's value, both 0 to 1; the same bits on every machine. */
  public static double light(double display) {
    return display <= 0.04045 ? display / 12.92 : StrictMath.pow((display + 0.055) / 1.055, 2.4);
  }

  /** The display's value of a share of light, both 0 to 1; the same bits on every machine. */
  public static double display(double light) {
    return light <= 0.0031308 ? light * 12.92 : 1.055 * StrictMath.pow(light, 1 / 2.4) - 0.055;
  }
}
