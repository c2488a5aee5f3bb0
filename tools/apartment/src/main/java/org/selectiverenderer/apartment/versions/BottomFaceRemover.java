package org.selectiverenderer.apartment.versions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Opens closed models at their undersides, where nobody looks: closed surfaces have even polygon
 * counts, and some of the thesis's counts are odd.
 */
final class BottomFaceRemover {

  private BottomFaceRemover() {}

  /**
   * Returns the model without its lowest triangle that faces down; the part of that triangle
   * becomes two-sided.
   */
  static List<Mesh> open(List<Mesh> parts) {
    int part = 0;
    int triangle = 0;
    double lowest = Double.POSITIVE_INFINITY;
    for (int p = 0; p < parts.size(); p++) {
      for (int t = 0; t < parts.get(p).polygons(); t++) {
        double height = height(parts.get(p), t);
        if (height < lowest) {
          lowest = height;
          part = p;
          triangle = t;
        }
      }
    }
    List<Mesh> opened = new ArrayList<>(parts);
    opened.set(part, without(parts.get(part), triangle));
    return opened;
  }

  /**
   * Returns the height of a triangle's centroid, metres, plus ten metres if the triangle does not
   * face down.
   */
  private static double height(Mesh mesh, int triangle) {
    float[] p = mesh.positions();
    int a = 3 * mesh.indices()[3 * triangle];
    int b = 3 * mesh.indices()[3 * triangle + 1];
    int c = 3 * mesh.indices()[3 * triangle + 2];
    double x = area(p, a, b, c, 1, 2);
    double y = area(p, a, b, c, 2, 0);
    double z = area(p, a, b, c, 0, 1);
    boolean down = y < -0.9 * Math.sqrt(x * x + y * y + z * z);
    return ((double) p[a + 1] + p[b + 1] + p[c + 1]) / 3 + (down ? 0 : 10);
  }

  private static double area(float[] p, int a, int b, int c, int u, int v) {
    return ((double) p[b + u] - p[a + u]) * ((double) p[c + v] - p[a + v])
        - ((double) p[b + v] - p[a + v]) * ((double) p[c + u] - p[a + u]);
  }

  private static Mesh without(Mesh mesh, int triangle) {
    int[] all = mesh.indices();
    int[] kept = Arrays.copyOf(all, all.length - 3);
    System.arraycopy(all, 3 * triangle + 3, kept, 3 * triangle, kept.length - 3 * triangle);
    return new Mesh(
        mesh.primitive(),
        mesh.positions(),
        mesh.normals(),
        mesh.colors(),
        mesh.texCoords(),
        kept,
        false,
        mesh.bounds());
  }
}
