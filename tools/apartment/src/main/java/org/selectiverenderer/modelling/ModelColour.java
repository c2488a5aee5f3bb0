package org.selectiverenderer.modelling;

import org.selectiverenderer.base.decimal.DecimalRounding;

/** A display colour: red, green and blue, 0 to 1 each. */
public record ModelColour(double red, double green, double blue) {

  public ModelColour {
    if (!isPart(red) || !isPart(green) || !isPart(blue)) {
      throw new IllegalArgumentException("a colour's parts are 0 to 1");
    }
  }

  private static boolean isPart(double value) {
    return value >= 0 && value <= 1;
  }

  public static ModelColour of(double red, double green, double blue) {
    return new ModelColour(red, green, blue);
  }

  public static ModelColour grey(double value) {
    return new ModelColour(value, value, value);
  }

  /** Returns the colour of a hexadecimal number such as {@code 0xC8A064}. */
  public static ModelColour hex(int rgb) {
    return new ModelColour(part(rgb >> 16), part(rgb >> 8), part(rgb));
  }

  private static double part(int bits) {
    return DecimalRounding.to(3, (bits & 0xFF) / 255.0);
  }
}
