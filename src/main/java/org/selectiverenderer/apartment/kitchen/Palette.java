package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.modelling.Colour;
import org.selectiverenderer.modelling.Look;

/** The looks that the kitchen's objects share, so that they go together. */
final class Palette {
  static final Look STEEL = polished(0xB4B8BC);
  static final Look DARK_STEEL = polished(0x6A6E72);
  static final Look CHINA = Look.glossy(Colour.hex(0xEDEAE2));
  static final Look BLUE_CHINA = Look.glossy(Colour.hex(0x7F9FB3));
  static final Look BLACK = Look.satin(Colour.hex(0x24262A));
  static final Look OAK = Look.satin(Colour.hex(0xB98A58));
  static final Look DARK_WOOD = Look.satin(Colour.hex(0x7A4F30));
  static final Look RED = Look.glossy(Colour.hex(0xA83A34));
  static final Look GLASS = Look.glossy(Colour.hex(0xC4D6D8)).transparent(0.58);
  static final Look CRUST = Look.matt(Colour.hex(0xB8793C));

  private Palette() {}

  /** Metal in a bright room: lighter than {@link Look#metal}, which mirrors nothing but lamps. */
  private static Look polished(int rgb) {
    return new Look(Colour.hex(rgb), Colour.grey(0.75), 0.5, 0, Colour.grey(0));
  }
}
