package org.selectiverenderer.radiosity.atlas;

import java.util.Locale;
import java.util.Random;

/** Shapes written in tests as X3D. */
final class X3dShapeFixtures {
  private X3dShapeFixtures() {}

  /** A light, without which there is nothing to be lit by. */
  static String lit(String shapes) {
    return "<PointLight location='0 50 0'/>" + shapes;
  }

  static String triangles(String points, String indices) {
    return """
    <Shape><Appearance><Material/></Appearance>
    <IndexedTriangleSet index='%s'><Coordinate point='%s'/></IndexedTriangleSet></Shape>
    """
        .formatted(indices, points);
  }

  static String shape(String geometry) {
    return "<Shape><Appearance><Material/></Appearance>" + geometry + "</Shape>";
  }

  /** A point of a surface by two parameters. */
  @FunctionalInterface
  interface Patch {
    double[] at(double s, double t);
  }

  /** A grid of quadrangles over s and t from 0 to 1, in two triangles each; vertices are shared. */
  static String grid(int columns, int rows, Patch patch) {
    StringBuilder points = new StringBuilder();
    StringBuilder indices = new StringBuilder();
    for (int j = 0; j <= rows; j++) {
      for (int i = 0; i <= columns; i++) {
        points.append(point(patch.at((double) i / columns, (double) j / rows)));
        if (i < columns && j < rows) {
          int a = j * (columns + 1) + i;
          int b = a + columns + 1;
          indices.append("%d %d %d %d %d %d ".formatted(a, a + 1, b + 1, a, b + 1, b));
        }
      }
    }
    return triangles(points.toString(), indices.toString());
  }

  static String point(double[] p) {
    return String.format(Locale.ROOT, "%.7g %.7g %.7g, ", p[0], p[1], p[2]);
  }

  static String torus() {
    return grid(
        60,
        30,
        (s, t) -> {
          double a = 2 * Math.PI * ((s * 60) % 60) / 60;
          double b = 2 * Math.PI * ((t * 30) % 30) / 30;
          double r = 1 + 0.3 * Math.cos(b);
          return new double[] {r * Math.cos(a), -0.3 * Math.sin(b), r * Math.sin(a)};
        });
  }

  static String moebius() {
    return grid(
        80,
        4,
        (s, t) -> {
          double a = 2 * Math.PI * s;
          double r = 1 + (t - 0.5) * 0.6 * Math.cos(a / 2);
          return new double[] {r * Math.cos(a), (t - 0.5) * 0.6 * Math.sin(a / 2), r * Math.sin(a)};
        });
  }

  /** A ramp that winds up around an axis three times: seen from above it lies on itself. */
  static String ramp() {
    return grid(
        120,
        2,
        (s, t) -> {
          double a = -6 * Math.PI * s;
          double r = 1 + t;
          return new double[] {r * Math.cos(a), 3 * s, r * Math.sin(a)};
        });
  }

  /** Triangles between random points, many of which share vertices and edges. */
  static String soup(long seed) {
    Random random = new Random(seed);
    int vertices = 12 + random.nextInt(60);
    StringBuilder points = new StringBuilder();
    for (int i = 0; i < vertices; i++) {
      points.append(
          point(new double[] {random.nextDouble(), random.nextDouble(), random.nextDouble() / 5}));
    }
    StringBuilder indices = new StringBuilder();
    for (int i = 0; i < 3 * (10 + random.nextInt(150)); i++) {
      indices.append(random.nextInt(vertices)).append(' ');
    }
    return triangles(points.toString(), indices.toString());
  }
}
