package org.selectiverenderer.apartment.looks;

import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.ModelColour;

/** Materials that several objects of a room share, so that they match. */
public final class Looks {
  // Wood.
  public static final Look OAK = Look.satin(ModelColour.of(0.66, 0.45, 0.27));
  public static final Look DARK_OAK = Look.satin(ModelColour.of(0.44, 0.28, 0.16));
  public static final Look LIGHT_OAK = Look.satin(ModelColour.hex(0xB98A58));
  public static final Look DARK_WOOD = Look.satin(ModelColour.hex(0x7A4F30));
  public static final Look WALNUT = Look.satin(ModelColour.of(0.36, 0.23, 0.14));

  // Metal.
  public static final Look CHROME = Look.metal(ModelColour.grey(0.85));
  public static final Look STEEL = Look.metal(ModelColour.of(0.8, 0.82, 0.85));
  public static final Look POLISHED_STEEL = polished(0xB4B8BC);
  public static final Look DARK_STEEL = polished(0x6A6E72);
  public static final Look BRASS = Look.metal(ModelColour.of(0.88, 0.7, 0.32));
  public static final Look PALE_BRASS = Look.metal(ModelColour.of(0.86, 0.68, 0.36));

  // Plastic and lacquer.
  public static final Look BLACK = Look.satin(ModelColour.of(0.09, 0.09, 0.1));
  public static final Look SOFT_BLACK = Look.satin(ModelColour.hex(0x24262A));
  public static final Look BLACK_PLASTIC = Look.satin(ModelColour.of(0.06, 0.06, 0.065));
  public static final Look CHARCOAL = Look.satin(ModelColour.of(0.21, 0.22, 0.24));
  public static final Look GREY = Look.satin(ModelColour.of(0.5, 0.51, 0.53));
  public static final Look SILVER = Look.satin(ModelColour.of(0.74, 0.75, 0.76));
  public static final Look WHITE = Look.satin(ModelColour.of(0.9, 0.9, 0.87));
  public static final Look CREAM_LACQUER = Look.satin(ModelColour.of(0.88, 0.85, 0.77));
  public static final Look RED = Look.glossy(ModelColour.of(0.72, 0.09, 0.07));
  public static final Look BRICK_RED = Look.glossy(ModelColour.hex(0xA83A34));
  public static final Look GREEN = Look.satin(ModelColour.of(0.16, 0.34, 0.25));
  public static final Look BLUE = Look.satin(ModelColour.of(0.16, 0.28, 0.44));
  public static final Look RUBBER = Look.matt(ModelColour.of(0.07, 0.07, 0.075));

  // China and glass.
  public static final Look CHINA = Look.glossy(ModelColour.hex(0xEDEAE2));
  public static final Look BLUE_CHINA = Look.glossy(ModelColour.hex(0x7F9FB3));
  public static final Look GLASS = Look.glossy(ModelColour.hex(0xC4D6D8)).transparent(0.58);

  // Paper, cloth and food.
  public static final Look PAPER = Look.matt(ModelColour.of(0.93, 0.92, 0.87));
  public static final Look CREAM_PAPER = Look.matt(ModelColour.of(0.93, 0.91, 0.85));
  public static final Look LINEN = Look.matt(ModelColour.of(0.66, 0.6, 0.5));
  public static final Look TEAL_CLOTH = Look.matt(ModelColour.of(0.16, 0.4, 0.42));
  public static final Look RUST_CLOTH = Look.matt(ModelColour.of(0.7, 0.34, 0.2));
  public static final Look CREAM_CLOTH = Look.matt(ModelColour.of(0.86, 0.81, 0.7));
  public static final Look CRUST = Look.matt(ModelColour.hex(0xB8793C));

  private Looks() {}

  /** Returns the material of a part of a lit screen. */
  public static Look lit(double red, double green, double blue) {
    return Look.glossy(ModelColour.grey(0.02)).glowing(ModelColour.of(red, green, blue));
  }

  /**
   * Returns metal for a bright room: lighter than {@link Look#metal}, which reflects lamps only.
   */
  private static Look polished(int rgb) {
    return new Look(ModelColour.hex(rgb), ModelColour.grey(0.75), 0.5, 0, ModelColour.grey(0));
  }
}
