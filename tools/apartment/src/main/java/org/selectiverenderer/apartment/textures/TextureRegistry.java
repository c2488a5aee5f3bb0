package org.selectiverenderer.apartment.textures;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.formats.image.Srgb;

/**
 * The registry of all textures by file name, as files of the folder {@code inlineNodes} name them.
 */
public final class TextureRegistry {
  public static final String PARQUET = "textures/parquet.png";
  public static final String TILES = "textures/floorTiles.png";
  public static final String WALL_TILES = "textures/wallTiles.png";
  public static final String PLASTER = "textures/plaster.png";
  public static final String CARPET = "textures/carpet.png";
  public static final String VENEER = "textures/veneer.png";

  /** The skybox images of the Background, by direction. */
  public static final String NORTH = "textures/outsideNorth.png";

  public static final String EAST = "textures/outsideEast.png";
  public static final String SOUTH = "textures/outsideSouth.png";
  public static final String WEST = "textures/outsideWest.png";

  /** Width and height of floor that the parquet texture shows, metres. */
  public static final double PARQUET_SIZE = Parquet.SIZE;

  /** Number of tiles in a row and in a column of the floor tile texture. */
  public static final int TILES_A_SIDE = FloorTiles.TILES;

  /** Width and height of wall that the wall tile texture shows, metres. */
  public static final double WALL_TILES_SIZE = WallTiles.SIZE;

  /** Width and height of wall that the plaster texture shows, metres. */
  public static final double PLASTER_SIZE = Plaster.SIZE;

  /** Mean factor by which the plaster texture scales its material's reflectance. */
  public static final double PLASTER_LIGHT = Plaster.MEAN_LIGHT;

  /** Width and height that the veneer texture shows, metres. */
  public static final double VENEER_WIDTH = Veneer.WIDTH;

  public static final double VENEER_HEIGHT = Veneer.HEIGHT;

  private TextureRegistry() {}

  /** Returns the function that computes each texture, by file name. */
  public static Map<String, Supplier<TextureImage>> all() {
    Map<String, Supplier<TextureImage>> all = new TreeMap<>();
    // The plain colours of the same surfaces without textures.
    double[] boards =
        light(
            new double[] {0.66, 0.46, 0.28},
            new double[] {0.58, 0.39, 0.23},
            new double[] {0.5, 0.33, 0.19});
    double[] tiles = light(new double[] {0.82, 0.79, 0.72}, new double[] {0.54, 0.34, 0.26});
    double[] china = light(new double[] {0.9, 0.885, 0.85});
    double[] door = light(new double[] {0.55, 0.36, 0.2});
    all.put(PARQUET, () -> Parquet.picture(boards));
    all.put(TILES, () -> FloorTiles.picture(tiles));
    all.put(WALL_TILES, () -> WallTiles.picture(china));
    all.put(PLASTER, Plaster::picture);
    all.put(CARPET, CarpetPattern::picture);
    all.put(VENEER, () -> Veneer.picture(door));
    all.put(NORTH, SkyboxFace.NORTH::picture);
    all.put(EAST, SkyboxFace.EAST::picture);
    all.put(SOUTH, SkyboxFace.SOUTH::picture);
    all.put(WEST, SkyboxFace.WEST::picture);
    return all;
  }

  /** Returns the mean reflectance of display colours. */
  private static double[] light(double[]... displays) {
    double[] mean = new double[3];
    for (double[] display : displays) {
      for (int c = 0; c < 3; c++) {
        mean[c] += Srgb.light(display[c]) / displays.length;
      }
    }
    return mean;
  }
}
