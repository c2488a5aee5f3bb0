package org.selectiverenderer.modelling;

/** Red, green and blue, 0 to 1 each. */
public record Colour(double red, double green, double blue) {

  public Colour {
    if (!isPart(red) || !isPart(green) || !isPart(blue)) {
      throw new IllegalArgumentException("a colour's parts are 0 to 1");
    }
  }

  private static boolean isPart(double value) {
    return value >= 0 && value <= 1;
  }

  public static Colour of(double red, double green, double blue) {
    return new Colour(red, green, blue);
  }

  public static Colour grey(double value) {
    return new Colour(value, value, value);
  }

  /** As in {@code 0xC8A064}. */
  public static Colour hex(int rgb) {
    return new Colour(part(rgb >> 16), part(rgb >> 8), part(rgb));
  }

  private static double part(int bits) {
    return Math.round((bits & 0xFF) / 255.0 * 1000) / 1000.0;
  }
}
