package org.selectiverenderer.apartment.frame;

import org.selectiverenderer.apartment.pictures.Pictures;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.base.decimal.Rounded;
import org.selectiverenderer.base.picture.Srgb;
import org.selectiverenderer.modelling.Cladding;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.ModelColour;

/** The finishes of the rooms: materials of walls, floors and fittings. */
final class Finish {
  /**
   * Colour of materials that show their texture alone, also in browsers that multiply textures by
   * the colour.
   */
  private static final ModelColour WHITE = ModelColour.grey(1);

  private static final Cladding PLASTER =
      Cladding.metric(Pictures.PLASTER, Pictures.PLASTER_SIZE, Pictures.PLASTER_SIZE);

  static final Look CEILING = Look.matt(ModelColour.of(0.95, 0.94, 0.92));
  static final Look TRIM = Look.satin(ModelColour.of(0.93, 0.92, 0.88));
  static final Look DOOR =
      Look.satin(WHITE)
          .clad(Cladding.metric(Pictures.VENEER, Pictures.VENEER_WIDTH, Pictures.VENEER_HEIGHT));
  static final Look STEEL = Look.metal(ModelColour.of(0.72, 0.72, 0.74));
  static final Look PLASTIC = Look.satin(ModelColour.of(0.94, 0.94, 0.91));
  static final Look GLASS = Look.glossy(ModelColour.of(0.75, 0.85, 0.9)).transparent(0.82);
  static final Look LIGHT =
      Look.matt(ModelColour.of(1, 0.98, 0.92)).glowing(ModelColour.of(0.95, 0.92, 0.82));

  private Finish() {}

  /**
   * Returns painted plaster; the paint is lighter by the factor by which the texture darkens it.
   */
  static Look wall(double red, double green, double blue) {
    return Look.matt(ModelColour.of(paint(red), paint(green), paint(blue))).clad(PLASTER);
  }

  private static double paint(double seen) {
    return Rounded.to(3, Srgb.display(Srgb.light(seen) / Pictures.PLASTER_LIGHT));
  }

  /** Returns parquet that runs east and west, from the room's north-west corner. */
  static Look parquet(Room room) {
    double size = Pictures.PARQUET_SIZE;
    return Look.satin(WHITE)
        .clad(Cladding.floor(room.west(), Room.NORTH, Pictures.PARQUET, size, size));
  }

  /**
   * Returns floor tiles, from the room's north-west corner.
   *
   * @param width width of a tile, metres
   */
  static Look tiles(Room room, double width, double depth) {
    int each = Pictures.TILES_A_SIDE;
    return Look.satin(WHITE)
        .clad(Cladding.floor(room.west(), Room.NORTH, Pictures.TILES, each * width, each * depth));
  }
}
