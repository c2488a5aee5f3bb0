package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.modelling.Colour;
import org.selectiverenderer.modelling.Look;

/** What several things of the lounge are made of, so that they go together. */
final class Looks {
  static final Look WALNUT = Look.satin(Colour.of(0.36, 0.23, 0.14));
  static final Look CREAM_LACQUER = Look.satin(Colour.of(0.88, 0.85, 0.77));
  static final Look BRASS = Look.metal(Colour.of(0.86, 0.68, 0.36));
  static final Look STEEL = Look.metal(Colour.of(0.8, 0.82, 0.85));
  static final Look BLACK_PLASTIC = Look.satin(Colour.of(0.06, 0.06, 0.065));
  static final Look PAPER = Look.matt(Colour.of(0.93, 0.91, 0.85));
  static final Look LINEN = Look.matt(Colour.of(0.66, 0.6, 0.5));
  static final Look TEAL_CLOTH = Look.matt(Colour.of(0.16, 0.4, 0.42));
  static final Look RUST_CLOTH = Look.matt(Colour.of(0.7, 0.34, 0.2));
  static final Look CREAM_CLOTH = Look.matt(Colour.of(0.86, 0.81, 0.7));

  private Looks() {}
}
