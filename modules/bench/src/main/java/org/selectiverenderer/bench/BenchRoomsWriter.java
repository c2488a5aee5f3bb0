package org.selectiverenderer.bench;

import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes floor, walls and areas of the heavy scene's rooms. */
final class BenchRoomsWriter {

  private static final double HALF_DEPTH = 3.5;
  private static final double WALL = 2.6;

  private BenchRoomsWriter() {}

  /**
   * @param enabled whether the areas' sensors are
   * @param bounds x of the walls across, from west to east; the inner ones are knee-high
   */
  static void write(X3dWriter out, boolean enabled, double... bounds) {
    double west = bounds[0];
    double east = bounds[bounds.length - 1];
    double middle = (west + east) / 2;
    double width = east - west;
    box(out, "0.62 0.56 0.48", middle, -0.05, 0, width, 0.1, 2 * HALF_DEPTH);
    for (int side = -1; side <= 1; side += 2) {
      box(out, WALLS, middle, WALL / 2, side * (HALF_DEPTH + 0.05), width, WALL, 0.1);
    }
    box(out, WALLS, west - 0.05, WALL / 2, 0, 0.1, WALL, 2 * HALF_DEPTH);
    box(out, WALLS, east + 0.05, WALL / 2, 0, 0.1, WALL, 2 * HALF_DEPTH);
    for (int i = 1; i + 1 < bounds.length; i++) {
      box(out, WALLS, bounds[i], 0.25, 0, 0.08, 0.5, 2 * HALF_DEPTH);
    }
    for (int room = 1; room < bounds.length; room++) {
      double x = (bounds[room - 1] + bounds[room]) / 2;
      area(out, enabled, "Room" + room, x, 0, bounds[room] - bounds[room - 1]);
    }
  }

  private static final String WALLS = "0.85 0.82 0.75";

  private static void box(
      X3dWriter out,
      String colour,
      double x,
      double y,
      double z,
      double width,
      double height,
      double depth) {
    out.open("Transform", "translation", numbers(x, y, z)).open("Shape");
    out.material("diffuseColor", colour);
    out.empty("Box", "size", numbers(width, height, depth)).close().close();
  }

  /**
   * Writes a sensor as deep and high as the house.
   *
   * @param name of the area, and of the schema that one activates by entering it
   */
  static void area(X3dWriter out, boolean enabled, String name, double x, double z, double width) {
    out.open("ProximitySensor", "DEF", name + "Prox");
    if (!enabled) {
      out.attribute("enabled", "false");
    }
    out.attribute(
        "center", DecimalFormatter.fixed(x, 3) + " 1.3 " + DecimalFormatter.rounded(z, 3));
    out.attribute("size", DecimalFormatter.fixed(width, 3) + " 2.6 7");
    out.open("MetadataSet", "containerField", "metadata");
    BenchSwitchWriter.string(out, "enterTimeSchema", name + "Schema");
    BenchSwitchWriter.string(out, "exitTimeSchema", "HouseSchema");
    out.close().close();
  }

  private static String numbers(double x, double y, double z) {
    return DecimalFormatter.fixed(x, 3)
        + " "
        + DecimalFormatter.fixed(y, 3)
        + " "
        + DecimalFormatter.fixed(z, 3);
  }
}
