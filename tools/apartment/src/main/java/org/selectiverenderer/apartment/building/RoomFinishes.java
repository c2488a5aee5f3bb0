package org.selectiverenderer.apartment.building;

import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.textures.TextureRegistry;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.formats.image.Srgb;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.TextureMapping;

/** The finishes of the rooms: materials of walls, floors and fittings. */
final class RoomFinishes {
  /**
   * Colour of materials that show their texture alone, also in browsers that multiply textures by
   * the colour.
   */
  private static final ModelColour WHITE = ModelColour.grey(1);

  private static final TextureMapping PLASTER =
      TextureMapping.metric(
          TextureRegistry.PLASTER, TextureRegistry.PLASTER_SIZE, TextureRegistry.PLASTER_SIZE);

  static final ModelMaterial CEILING = ModelMaterial.matt(ModelColour.of(0.95, 0.94, 0.92));
  static final ModelMaterial TRIM = ModelMaterial.satin(ModelColour.of(0.93, 0.92, 0.88));
  static final ModelMaterial DOOR =
      ModelMaterial.satin(WHITE)
          .clad(
              TextureMapping.metric(
                  TextureRegistry.VENEER,
                  TextureRegistry.VENEER_WIDTH,
                  TextureRegistry.VENEER_HEIGHT));
  static final ModelMaterial STEEL = ModelMaterial.metal(ModelColour.of(0.72, 0.72, 0.74));
  static final ModelMaterial PLASTIC = ModelMaterial.satin(ModelColour.of(0.94, 0.94, 0.91));
  static final ModelMaterial GLASS =
      ModelMaterial.glossy(ModelColour.of(0.75, 0.85, 0.9)).transparent(0.82);
  static final ModelMaterial LIGHT =
      ModelMaterial.matt(ModelColour.of(1, 0.98, 0.92)).glowing(ModelColour.of(0.95, 0.92, 0.82));

  private RoomFinishes() {}

  /**
   * Returns painted plaster; the paint is lighter by the factor by which the texture darkens it.
   */
  static ModelMaterial wall(double red, double green, double blue) {
    return ModelMaterial.matt(ModelColour.of(paint(red), paint(green), paint(blue))).clad(PLASTER);
  }

  private static double paint(double seen) {
    return DecimalRounding.to(3, Srgb.display(Srgb.light(seen) / TextureRegistry.PLASTER_LIGHT));
  }

  /** Returns parquet that runs east and west, from the room's north-west corner. */
  static ModelMaterial parquet(Room room) {
    double size = TextureRegistry.PARQUET_SIZE;
    return ModelMaterial.satin(WHITE)
        .clad(TextureMapping.floor(room.west(), Room.NORTH, TextureRegistry.PARQUET, size, size));
  }

  /**
   * Returns floor tiles, from the room's north-west corner.
   *
   * @param width width of a tile, metres
   */
  static ModelMaterial tiles(Room room, double width, double depth) {
    int each = TextureRegistry.TILES_A_SIDE;
    return ModelMaterial.satin(WHITE)
        .clad(
            TextureMapping.floor(
                room.west(), Room.NORTH, TextureRegistry.TILES, each * width, each * depth));
  }
}
