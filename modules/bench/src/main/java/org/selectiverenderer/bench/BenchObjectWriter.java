package org.selectiverenderer.bench;

import java.util.Locale;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes an object of a benchmark scene: an IndexedFaceSet with a normal per point. */
final class BenchObjectWriter {

  private BenchObjectWriter() {}

  /**
   * @param name DEF name of the Shape
   * @param number picks the colour
   */
  static String text(String name, int number, SurfaceMesh mesh) {
    X3dWriter out = new X3dWriter(21 * mesh.triangles().length + 16 * mesh.points().length + 800);
    write(out.file("Interchange", "3.3").open("Scene"), name, number, mesh);
    return out.finish();
  }

  /** Writes the Shape alone into an open file. */
  static void write(X3dWriter out, String name, int number, SurfaceMesh mesh) {
    StringBuilder index = new StringBuilder(7 * mesh.triangles().length);
    int[] triangles = mesh.triangles();
    for (int t = 0; t < triangles.length; t += 3) {
      index.append(triangles[t]).append(' ').append(triangles[t + 1]).append(' ');
      index.append(triangles[t + 2]).append(" -1 ");
    }
    out.open("Shape", "DEF", name);
    out.material(
        "diffuseColor", colour(number), "specularColor", "0.3 0.3 0.3", "shininess", "0.3");
    out.open("IndexedFaceSet").numbers("coordIndex", index);
    out.open("Coordinate").numbers("point", fixed(mesh.points(), 5)).close();
    out.open("Normal").numbers("vector", fixed(mesh.normals(), 3)).close().close().close();
  }

  private static StringBuilder fixed(double[] values, int decimals) {
    StringBuilder text = new StringBuilder((decimals + 4) * values.length);
    for (double value : values) {
      DecimalFormatter.appendFixed(text, value, decimals);
      text.append(' ');
    }
    return text;
  }

  /** Colours a golden angle apart in hue, so that neighbours differ. */
  private static String colour(int number) {
    double hue = 2.39996 * number;
    return String.format(
        Locale.ROOT,
        "%.2f %.2f %.2f",
        0.55 + 0.3 * Math.cos(hue),
        0.55 + 0.3 * Math.cos(hue - 2 * Math.PI / 3),
        0.55 + 0.3 * Math.cos(hue + 2 * Math.PI / 3));
  }
}
