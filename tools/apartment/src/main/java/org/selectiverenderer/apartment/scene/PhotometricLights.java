package org.selectiverenderer.apartment.scene;

import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes the light sources of a room for radiosity, which computes the indirect light: daylight in
 * the windows and the lamps, as SpotLights whose metadata gives their size and emission.
 * Coordinates are above the floor; each light stands free in front of its pane or lamp.
 */
final class PhotometricLights {
  /** Clear sky and sunlit ground as seen through panes, cd/m2. */
  private static final double DAYLIGHT = 2600;

  private static final String SKY = "0.97 0.985 1";
  private static final String WARM = "1 0.93 0.82";
  private static final String WHITE = "1 0.98 0.94";

  /** Distance of the daylight into a window's reveal, metres. */
  private static final double REVEAL = 0.04;

  private PhotometricLights() {}

  static void write(X3dWriter xml, Room room) {
    switch (room) {
      case KITCHEN -> {
        window(xml, -0.1, 1.65, Room.NORTH - REVEAL, "0 0 1", 1.5, 1.1, 1.25);
        lamp(xml, "-0.95 1.69 1.15", WARM, 0.08, 0.08, 1500);
      }
      case LOUNGE -> {
        window(xml, room.west() - REVEAL, 1.6, 0.9, "1 0 0", 2.2, 1.3, 1);
        window(xml, -4, 1.6, Room.SOUTH + REVEAL, "0 0 -1", 1.6, 1.3, 1);
      }
      case OFFICE -> {
        window(xml, 6.6, 1.6, Room.NORTH - REVEAL, "0 0 1", 1.9, 1.3, 1);
        lamp(xml, "4.3 2.55 0", WHITE, 1.16, 0.26, 2600);
        lamp(xml, "6.9 2.55 0", WHITE, 1.16, 0.26, 2600);
      }
    }
  }

  private static void window(
      X3dWriter xml,
      double x,
      double y,
      double z,
      String direction,
      double width,
      double height,
      double brighter) {
    open(xml, FieldValueText.numbers(x, y, z), direction, SKY);
    size(xml, width, height);
    value(xml, "luminance", DAYLIGHT * brighter);
    xml.close().close();
  }

  private static void lamp(
      X3dWriter xml, String place, String colour, double width, double depth, double lumen) {
    open(xml, place, "0 -1 0", colour);
    size(xml, width, depth);
    value(xml, "lumen", lumen);
    xml.close().close();
  }

  private static void open(X3dWriter xml, String place, String direction, String colour) {
    xml.open(
        "SpotLight",
        "location",
        place,
        "direction",
        direction,
        "color",
        colour,
        "cutOffAngle",
        "1.5707",
        "radius",
        "12",
        "global",
        "false");
    xml.open("MetadataSet", "containerField", "metadata", "name", "photometric");
  }

  private static void size(X3dWriter xml, double width, double height) {
    xml.empty(
        "MetadataFloat",
        "containerField",
        "value",
        "name",
        "size",
        "value",
        FieldValueText.numbers(width, height));
  }

  private static void value(X3dWriter xml, String name, double value) {
    xml.empty(
        "MetadataFloat",
        "containerField",
        "value",
        "name",
        name,
        "value",
        DecimalFormatter.rounded(value, 0));
  }
}
