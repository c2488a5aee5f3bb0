package org.selectiverenderer.geometry.font;

import java.util.Arrays;

/** Flattens contours of lines and quadratic Bézier curves to polygons. */
final class BezierFlattener {
  /** The flattening tolerance in font units: 1/512 of an em of 2048 units. */
  private static final double TOLERANCE = 4;

  private float[] polygon = new float[64];
  private int length;

  private BezierFlattener() {}

  /**
   * Returns the polygon of a contour. The midpoint of two consecutive off-curve points is an
   * implied on-curve point.
   *
   * @param flags TrueType point flags, which tell on-curve from off-curve points
   * @param from index of the contour's first point
   * @param to index after its last point
   * @return x, y per point, the first not repeated at the end
   */
  static float[] flatten(float[] x, float[] y, byte[] flags, int from, int to) {
    BezierFlattener curves = new BezierFlattener();
    int first = from;
    while (first < to && !GlyphOutlineReader.onCurve(flags[first])) {
      first++;
    }
    float startX;
    float startY;
    if (first < to) {
      startX = x[first];
      startY = y[first];
    } else {
      first = from;
      startX = (x[from] + x[to - 1]) / 2;
      startY = (y[from] + y[to - 1]) / 2;
      first--;
    }
    int count = to - from;
    float atX = startX;
    float atY = startY;
    curves.add(atX, atY);
    int steps = first < from ? count : count - 1;
    for (int step = 1; step <= steps; step++) {
      int i = from + (first - from + step) % count;
      if (GlyphOutlineReader.onCurve(flags[i])) {
        curves.add(x[i], y[i]);
        atX = x[i];
        atY = y[i];
        continue;
      }
      int next = from + (i - from + 1) % count;
      boolean last = step == steps;
      float endX =
          last ? startX : GlyphOutlineReader.onCurve(flags[next]) ? x[next] : (x[i] + x[next]) / 2;
      float endY =
          last ? startY : GlyphOutlineReader.onCurve(flags[next]) ? y[next] : (y[i] + y[next]) / 2;
      curves.curve(atX, atY, x[i], y[i], endX, endY);
      atX = endX;
      atY = endY;
      if (!last && GlyphOutlineReader.onCurve(flags[next])) {
        step++;
      }
    }
    return curves.closed();
  }

  /**
   * Adds a curve without its start point. A curve divided into n segments deviates from them by at
   * most |start - 2 control + end| / (4 n²).
   */
  private void curve(float x0, float y0, float cx, float cy, float x1, float y1) {
    double deviation = Math.hypot(x0 - 2 * cx + x1, y0 - 2 * cy + y1) / 4;
    int parts = Math.max(1, (int) Math.ceil(Math.sqrt(deviation / TOLERANCE)));
    for (int i = 1; i < parts; i++) {
      double t = (double) i / parts;
      double u = 1 - t;
      add(
          (float) (u * u * x0 + 2 * u * t * cx + t * t * x1),
          (float) (u * u * y0 + 2 * u * t * cy + t * t * y1));
    }
    add(x1, y1);
  }

  private void add(float x, float y) {
    if (length > 0 && polygon[length - 2] == x && polygon[length - 1] == y) {
      return;
    }
    if (length == polygon.length) {
      polygon = Arrays.copyOf(polygon, 2 * length);
    }
    polygon[length++] = x;
    polygon[length++] = y;
  }

  private float[] closed() {
    while (length > 2 && polygon[length - 2] == polygon[0] && polygon[length - 1] == polygon[1]) {
      length -= 2;
    }
    return Arrays.copyOf(polygon, length);
  }
}
