package org.selectiverenderer.scenes;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * A soft dark disc of radius 1, just above y = 0: where an object meets the floor.
 *
 * <p>Without a Material its colours are not lit, and their fourth component is opacity (X3D 4.0,
 * 11.4.2 ColorRGBA).
 */
final class ContactShadow {

  private static final int STEPS = 24;
  private static final double HEIGHT = 0.002;

  /** Radius and opacity from the centre outwards; the edge fades out. */
  private static final double[][] RINGS = {{0, 0.5}, {0.35, 0.46}, {0.6, 0.3}, {0.8, 0.12}, {1, 0}};

  private ContactShadow() {}

  static void write(X3dWriter out) {
    List<double[]> points = new ArrayList<>();
    List<int[]> triangles = new ArrayList<>();
    StringBuilder colours = new StringBuilder();
    for (double[] ring : RINGS) {
      int steps = ring[0] == 0 ? 1 : STEPS;
      for (int s = 0; s < steps; s++) {
        double angle = 2 * Math.PI * s / STEPS;
        points.add(new double[] {ring[0] * Math.cos(angle), HEIGHT, -ring[0] * Math.sin(angle)});
        colours.append(String.format(Locale.ROOT, "0 0 0 %.2f ", ring[1]));
      }
    }
    for (int s = 0; s < STEPS; s++) {
      int next = (s + 1) % STEPS;
      triangles.add(new int[] {0, 1 + s, 1 + next});
      for (int ring = 1; ring + 1 < RINGS.length; ring++) {
        int inner = 1 + (ring - 1) * STEPS;
        int outer = inner + STEPS;
        triangles.add(new int[] {inner + s, outer + s, outer + next});
        triangles.add(new int[] {inner + s, outer + next, inner + next});
      }
    }
    TriangleMesh mesh = new TriangleMesh(points, triangles);
    out.open("Shape", "DEF", "ContactShadow").empty("Appearance");
    out.open("IndexedFaceSet").ownLine().numbers("coordIndex", mesh.coordIndexText());
    out.empty("Coordinate", "point", mesh.pointText());
    out.empty("ColorRGBA", "color", colours.toString().strip()).close().close();
  }
}
