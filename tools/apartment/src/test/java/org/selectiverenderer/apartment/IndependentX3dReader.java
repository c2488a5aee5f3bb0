package org.selectiverenderer.apartment;

/** Reads back what an object's file says, with a few lines that share nothing with our reader. */
final class IndependentX3dReader {

  private IndependentX3dReader() {}

  /** Triangles of all its Shapes without an area, or with one point twice. */
  static int linesAmongTriangles(String text) {
    int flat = 0;
    int at = text.indexOf("coordIndex='");
    while (at >= 0) {
      flat +=
          linesAmongTriangles(
              numbers(attribute(text, "coordIndex='", at)),
              numbers(attribute(text, " point='", at)));
      at = text.indexOf("coordIndex='", at + 1);
    }
    return flat;
  }

  private static int linesAmongTriangles(double[] index, double[] p) {
    int flat = 0;
    for (int i = 0; i < index.length; i += 4) {
      int a = 3 * (int) index[i];
      int b = 3 * (int) index[i + 1];
      int c = 3 * (int) index[i + 2];
      double[] u = {p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]};
      double[] v = {p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]};
      double x = u[1] * v[2] - u[2] * v[1];
      double y = u[2] * v[0] - u[0] * v[2];
      double z = u[0] * v[1] - u[1] * v[0];
      flat += x * x + y * y + z * z < 1e-24 ? 1 : 0;
    }
    return flat;
  }

  private static String attribute(String text, String name, int from) {
    int start = text.indexOf(name, from) + name.length();
    return text.substring(start, text.indexOf('\'', start));
  }

  private static double[] numbers(String text) {
    String[] words = text.strip().split("\\s+");
    double[] numbers = new double[words.length];
    for (int i = 0; i < words.length; i++) {
      numbers[i] = Double.parseDouble(words[i]);
    }
    return numbers;
  }
}
