package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The bounding boxes of all charts in whole texels, and their positions on the pages. A chart is
 * stretched to fill its box, so that the centres of a rectangular chart's texels are all inside of
 * it.
 */
final class ChartRectangles {
  /**
   * Width of the gutter: texels between two charts, and between a chart and the right and upper
   * border of a page.
   */
  static final int GUTTER = 2;

  /** Part of a texel by which a chart may be wider than its box and is squeezed into it. */
  private static final double SQUEEZE = 0.05;

  private final @Nullable UvCharts[] bodies;
  private final int[] first;
  final int[] width;
  final int[] height;
  final int[] x;
  final int[] y;

  /**
   * @param bodies the charts of each body; null for bodies without a page
   */
  ChartRectangles(@Nullable UvCharts[] bodies) {
    this.bodies = bodies;
    first = new int[bodies.length + 1];
    for (int i = 0; i < bodies.length; i++) {
      UvCharts charts = bodies[i];
      first[i + 1] = first[i] + (charts == null ? 0 : charts.charts());
    }
    int count = first[bodies.length];
    width = new int[count];
    height = new int[count];
    x = new int[count];
    y = new int[count];
  }

  /** Returns the number of a body's first chart among the charts of all bodies. */
  int first(int body) {
    return first[body];
  }

  int end(int body) {
    return first[body + 1];
  }

  /**
   * Sets the sizes of a body's boxes at a density, texels per metre; returns the number of texels
   * that they take, gutters included.
   */
  long size(int body, double density) {
    UvCharts charts = bodies[body];
    long sum = 0;
    for (int i = first[body]; i < first[body + 1]; i++) {
      width[i] = texels(charts.width()[i - first[body]], density);
      height[i] = texels(charts.height()[i - first[body]], density);
      sum += (long) (width[i] + GUTTER) * (height[i] + GUTTER);
    }
    return sum;
  }

  /** Returns whether all boxes of a body have the least size, one texel. */
  boolean least(int body) {
    return longest(body) <= 1;
  }

  /** Returns the longest side of a body's boxes, texels. */
  int longest(int body) {
    return first[body] == first[body + 1]
        ? 0
        : Math.max(
            Arrays.stream(width, first[body], first[body + 1]).max().getAsInt(),
            Arrays.stream(height, first[body], first[body + 1]).max().getAsInt());
  }

  private static int texels(double length, double density) {
    return (int) Math.max(1, Math.min(1 << 20, Math.ceil(length * density - SQUEEZE)));
  }

  /** Returns the x coordinate of a chart's corner on its page, texels. */
  double column(int box, UvCharts charts, int chart, int corner) {
    float wide = charts.width()[chart];
    return x[box] + width[box] * (wide > 0 ? charts.flat()[corner] / (double) wide : 0.5);
  }

  double row(int box, UvCharts charts, int chart, int corner) {
    float high = charts.height()[chart];
    return y[box] + height[box] * (high > 0 ? charts.flat()[corner + 1] / (double) high : 0.5);
  }
}
