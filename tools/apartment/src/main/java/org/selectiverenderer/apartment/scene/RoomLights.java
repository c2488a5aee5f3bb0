package org.selectiverenderer.apartment.scene;

import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes the lights of a room for the unlit scene: daylight from its windows, fill lights for the
 * light reflected by walls and floor, and a lamp. Each light reaches its own room only, so that no
 * shape has more than five.
 */
final class RoomLights {

  private RoomLights() {}

  static void write(X3dWriter xml, Room room) {
    switch (room) {
      case KITCHEN -> {
        sun(xml, "0.35 -0.62 0.7", "1 0.98 0.94", "0.56");
        fill(xml, "-0.75 -0.25 -0.6", "1 0.97 0.92", "0.38");
        fill(xml, "0.05 1 -0.1", "1 0.93 0.85", "0.52");
        fill(xml, "0.85 -0.2 -0.3", "0.95 0.97 1", "0.3");
        lamp(xml, "-0.4 0.3 0.4", "1 0.95 0.86", "0.55");
      }
      case LOUNGE -> {
        sun(xml, "0.8 -0.55 -0.25", "1 0.96 0.88", "0.62");
        fill(xml, "-0.7 -0.3 0.55", "0.96 0.97 1", "0.46");
        fill(xml, "0.05 1 0.1", "1 0.9 0.78", "0.58");
        fill(xml, "0.2 -0.2 -0.95", "1 0.97 0.93", "0.4");
        lamp(xml, "-7.6 0 2", "1 0.93 0.8", "0.6");
      }
      case OFFICE -> {
        sun(xml, "-0.3 -0.6 0.72", "1 0.98 0.93", "0.62");
        fill(xml, "0.78 -0.25 -0.5", "1 0.98 0.95", "0.46");
        fill(xml, "0 1 0.1", "1 0.92 0.82", "0.58");
        fill(xml, "-0.85 -0.2 -0.25", "0.97 0.98 1", "0.42");
        lamp(xml, "5.5 0.35 0", "0.98 0.98 1", "0.55");
      }
    }
  }

  private static void sun(X3dWriter xml, String direction, String colour, String intensity) {
    xml.empty(
        "DirectionalLight",
        "direction",
        direction,
        "color",
        colour,
        "intensity",
        intensity,
        "ambientIntensity",
        "0.6");
  }

  private static void fill(X3dWriter xml, String direction, String colour, String intensity) {
    xml.empty("DirectionalLight", "direction", direction, "color", colour, "intensity", intensity);
  }

  private static void lamp(X3dWriter xml, String location, String colour, String intensity) {
    xml.empty(
        "PointLight",
        "location",
        location,
        "color",
        colour,
        "intensity",
        intensity,
        "attenuation",
        "1 0 0.05",
        "radius",
        "12",
        "global",
        "false");
  }
}
