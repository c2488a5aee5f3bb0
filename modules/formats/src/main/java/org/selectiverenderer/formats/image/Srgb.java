package org.selectiverenderer.formats.image;

/** Converts between sRGB values and linear light (IEC 61966-2-1). */
public final class Srgb {

  private Srgb() {}

  /** Returns the linear light of an sRGB value, both 0 to 1; bit-identical on every machine. */
  public static double light(double display) {
    return display <= 0.04045 ? display / 12.92 : StrictMath.pow((display + 0.055) / 1.055, 2.4);
  }

  /** Returns the sRGB value of linear light, both 0 to 1; bit-identical on every machine. */
  public static double display(double light) {
    return light <= 0.0031308 ? light * 12.92 : 1.055 * StrictMath.pow(light, 1 / 2.4) - 0.055;
  }
}
