package org.selectiverenderer.apartment.office;

import org.selectiverenderer.modelling.Colour;
import org.selectiverenderer.modelling.Look;

/** Materials that several objects of the office share. */
final class Looks {
  static final Look OAK = Look.satin(Colour.of(0.66, 0.45, 0.27));
  static final Look DARK_OAK = Look.satin(Colour.of(0.44, 0.28, 0.16));
  static final Look BLACK = Look.satin(Colour.of(0.09, 0.09, 0.1));
  static final Look CHARCOAL = Look.satin(Colour.of(0.21, 0.22, 0.24));
  static final Look GREY = Look.satin(Colour.of(0.5, 0.51, 0.53));
  static final Look SILVER = Look.satin(Colour.of(0.74, 0.75, 0.76));
  static final Look WHITE = Look.satin(Colour.of(0.9, 0.9, 0.87));
  static final Look CHROME = Look.metal(Colour.grey(0.85));
  static final Look BRASS = Look.metal(Colour.of(0.88, 0.7, 0.32));
  static final Look RED = Look.glossy(Colour.of(0.72, 0.09, 0.07));
  static final Look GREEN = Look.satin(Colour.of(0.16, 0.34, 0.25));
  static final Look BLUE = Look.satin(Colour.of(0.16, 0.28, 0.44));
  static final Look PAPER = Look.matt(Colour.of(0.93, 0.92, 0.87));
  static final Look RUBBER = Look.matt(Colour.of(0.07, 0.07, 0.075));

  private Looks() {}

  /** A piece of a lit screen. */
  static Look lit(double red, double green, double blue) {
    return Look.glossy(Colour.grey(0.02)).glowing(Colour.of(red, green, blue));
  }
}
