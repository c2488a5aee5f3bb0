package org.selectiverenderer.apartment.frame;

import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.ModelColour;

/** The materials of the rooms. */
final class Finish {
  static final Look CEILING = Look.matt(ModelColour.of(0.95, 0.94, 0.92));
  static final Look TRIM = Look.satin(ModelColour.of(0.93, 0.92, 0.88));
  static final Look DOOR = Look.satin(ModelColour.of(0.55, 0.36, 0.2));
  static final Look STEEL = Look.metal(ModelColour.of(0.72, 0.72, 0.74));
  static final Look PLASTIC = Look.satin(ModelColour.of(0.94, 0.94, 0.91));
  static final Look GLASS = Look.glossy(ModelColour.of(0.75, 0.85, 0.9)).transparent(0.82);
  static final Look LIGHT =
      Look.matt(ModelColour.of(1, 0.98, 0.92)).glowing(ModelColour.of(0.95, 0.92, 0.82));

  static final Look LIGHT_BOARD = Look.satin(ModelColour.of(0.66, 0.46, 0.28));
  static final Look BOARD = Look.satin(ModelColour.of(0.58, 0.39, 0.23));
  static final Look DARK_BOARD = Look.satin(ModelColour.of(0.5, 0.33, 0.19));

  private Finish() {}

  /** Painted plaster. */
  static Look wall(double red, double green, double blue) {
    return Look.matt(ModelColour.of(red, green, blue));
  }
}
