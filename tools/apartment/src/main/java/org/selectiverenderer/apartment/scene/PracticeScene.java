package org.selectiverenderer.apartment.scene;

import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * The scene in which participants learn to walk and look round (thesis 6.1.4, Figs 84 and 85):
 * coloured boxes, cylinders, cones and spheres on a wide floor, with room to walk between them.
 */
public final class PracticeScene {
  private static final int ROWS = 5;
  private static final double SPACING = 3;

  private PracticeScene() {}

  public static String text() {
    X3dWriter xml = new X3dWriter().file("Immersive", "3.3");
    xml.open("head").meta("title", "practice.x3d");
    xml.meta("description", "Shapes to walk between (thesis Figures 84 and 85)");
    xml.meta("generator", "./selective-renderer apartment").meta("license", "MIT");
    xml.close().open("Scene");
    xml.empty(
        "NavigationInfo",
        "type",
        "\"WALK\" \"ANY\"",
        "avatarSize",
        FieldValueText.numbers(0.25, ApartmentSceneWriter.EYE, 0.3),
        "speed",
        "1.2",
        "headlight",
        "false");
    viewpoint(xml, "StartView", "Start", "0 1.2 11", 0, -4, "0.95");
    viewpoint(xml, "MiddleView", "Middle", "1.5 1.2 1.5", 30, -4, "0.95");
    viewpoint(xml, "AboveView", "From above", "0 19 15", 0, -52, "0.8");
    xml.empty("Background", "skyColor", "0.35 0.55 0.8 0.9 0.94 0.97", "skyAngle", "1.57");
    light(xml, "-0.5 -0.8 -0.4", "0.85", "0.8");
    light(xml, "0.7 -0.3 -0.6", "0.5", "0");
    light(xml, "-0.2 -0.2 0.9", "0.4", "0");
    light(xml, "0 1 0", "0.3", "0");
    floor(xml);
    for (int row = 0; row < ROWS; row++) {
      for (int column = 0; column < ROWS; column++) {
        shape(xml, row, column);
      }
    }
    return xml.finish();
  }

  private static void viewpoint(
      X3dWriter xml,
      String def,
      String name,
      String position,
      double yaw,
      double pitch,
      String fieldOfView) {
    xml.empty(
        "Viewpoint",
        "DEF",
        def,
        "description",
        name,
        "position",
        position,
        "orientation",
        FieldValueText.orientation(yaw, pitch),
        "fieldOfView",
        fieldOfView);
  }

  private static void light(X3dWriter xml, String direction, String intensity, String ambient) {
    xml.empty(
        "DirectionalLight",
        "direction",
        direction,
        "intensity",
        intensity,
        "ambientIntensity",
        ambient);
  }

  /** Writes a chequered floor of two-metre squares, so that participants see themselves move. */
  private static void floor(X3dWriter xml) {
    StringBuilder colours = new StringBuilder();
    for (int z = 0; z < 15; z++) {
      for (int x = 0; x < 15; x++) {
        colours.append((x + z) % 2 == 0 ? "0.62 0.64 0.6 " : "0.54 0.57 0.54 ");
      }
    }
    xml.open("Transform", "DEF", "Floor", "translation", "-15 0 -15").open("Shape");
    xml.material();
    xml.open(
        "ElevationGrid",
        "xDimension",
        "16",
        "zDimension",
        "16",
        "xSpacing",
        "2",
        "zSpacing",
        "2",
        "colorPerVertex",
        "false",
        "height",
        "0 ".repeat(256).strip());
    xml.empty("Color", "color", colours.toString().strip()).close().close().close();
  }

  private static void shape(X3dWriter xml, int row, int column) {
    int number = row * ROWS + column;
    int kind = (row + 2 * column) % 4;
    double half = SPACING * (ROWS - 1) / 2;
    // Positions are slightly off the grid, so that the ways between are no straight corridors.
    double x = SPACING * column - half + 0.35 * DegreeMath.sin(137 * number);
    double z = SPACING * row - half + 0.35 * DegreeMath.cos(137 * number);
    double height = kind == 3 ? 1.2 : 0.9 + 0.15 * (number * 7 % 8);
    xml.open(
        "Transform",
        "DEF",
        "Shape_" + (number + 1),
        "translation",
        FieldValueText.numbers(x, height / 2, z),
        "rotation",
        FieldValueText.yaw(kind == 0 ? 17 * number : 0));
    xml.open("Shape");
    xml.material(
        "diffuseColor", colour(number), "specularColor", "0.25 0.25 0.25", "shininess", "0.3");
    switch (kind) {
      case 0 -> xml.empty("Box", "size", FieldValueText.numbers(0.9, height, 0.9));
      case 1 -> xml.empty("Cylinder", "radius", "0.45", "height", FieldValueText.numbers(height));
      case 2 -> xml.empty("Cone", "bottomRadius", "0.55", "height", FieldValueText.numbers(height));
      default -> xml.empty("Sphere", "radius", FieldValueText.numbers(height / 2));
    }
    xml.close().close();
  }

  /** Returns a colour; hues are a golden angle apart, so that neighbours differ. */
  private static String colour(int number) {
    double hue = 137.508 * number;
    ModelColour colour =
        ModelColour.of(
            0.55 + 0.35 * DegreeMath.cos(hue),
            0.5 + 0.35 * DegreeMath.cos(hue - 120),
            0.5 + 0.35 * DegreeMath.cos(hue + 120));
    return FieldValueText.numbers(colour.red(), colour.green(), colour.blue());
  }
}
