package org.selectiverenderer.apartment.building;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * A blob shadow: a dark spot with a soft edge on the floor, for an object whose footprint reaches
 * from -1 to 1 in x and z. X3D's lights cast no shadows; the thesis had those of radiosity in the
 * meshes of its floors (5.2.1).
 */
public final class BlobShadow {
  /** The file's name in {@code inlineNodes/}. */
  public static final String FILE = "softShadow.x3d";

  /** Height above the floor, metres: small enough to look painted on. */
  public static final double LIFT = 0.002;

  private static final int PER_CORNER = 2;
  private static final double[][] RINGS = {{0.78, 0.52}, {1.0, 0.3}, {1.16, 0.08}, {1.3, 0}};

  private BlobShadow() {}

  /**
   * Returns the number of triangles of the file: those inside the innermost ring, and the bands
   * around it.
   */
  public static int polygons() {
    int points = 4 * PER_CORNER;
    return points - 2 + 2 * points * (RINGS.length - 1);
  }

  /** Returns the file's text. */
  public static String text() {
    List<String> points = new ArrayList<>();
    List<String> colours = new ArrayList<>();
    for (int ring = 0; ring < RINGS.length; ring++) {
      double size = RINGS[ring][0];
      SimplePolygon outline =
          SimplePolygon.roundedRectangle(2 * size, 2 * size, 0.3 * size, PER_CORNER - 1);
      for (int i = 0; i < outline.size(); i++) {
        points.add(number(outline.x(i)) + " 0 " + number(-outline.y(i)));
        colours.add("0 0 0 " + number(RINGS[ring][1]));
      }
    }
    X3dWriter out = new X3dWriter().file("Interchange", "3.3");
    out.open("head").meta("title", FILE);
    out.meta("description", "Soft shadow on a floor, for a footprint from -1 to 1");
    out.meta("generator", "./selective-renderer apartment").meta("license", "MIT").close();
    out.open("Scene").open("Shape", "DEF", "SoftShadow").empty("Appearance");
    out.open("IndexedFaceSet", "coordIndex", String.join(" ", faces()));
    out.empty("Coordinate", "point", String.join(" ", points));
    out.empty("ColorRGBA", "color", String.join(" ", colours));
    return out.finish();
  }

  private static List<String> faces() {
    int points = 4 * PER_CORNER;
    List<String> faces = new ArrayList<>();
    for (int i = 1; i + 1 < points; i++) {
      faces.add(face(0, i, i + 1));
    }
    for (int ring = 0; ring + 1 < RINGS.length; ring++) {
      for (int i = 0; i < points; i++) {
        int next = (i + 1) % points;
        int inner = ring * points;
        int outer = inner + points;
        faces.add(face(inner + i, outer + i, outer + next));
        faces.add(face(inner + i, outer + next, inner + next));
      }
    }
    return faces;
  }

  private static String face(int a, int b, int c) {
    return a + " " + b + " " + c + " -1";
  }

  private static String number(double value) {
    return DecimalFormatter.rounded(value, 4);
  }
}
