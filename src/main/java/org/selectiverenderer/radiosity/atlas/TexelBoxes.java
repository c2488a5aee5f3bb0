package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The charts of all bodies as boxes of whole texels, and where they lie on their pages. A chart is
 * stretched to fill its box, so that the centres of a rectangle's texels are all inside of it.
 */
final class TexelBoxes {
  /** Texels between two charts, and between a chart and the right and upper border of a page. */
  static final int GUTTER = 2;

  /** A chart this part of a texel wider than its box still fits in. */
  private static final double SQUEEZE = 0.05;

  private final @Nullable BodyCharts[] bodies;
  private final int[] first;
  final int[] width;
  final int[] height;
  final int[] x;
  final int[] y;

  /**
   * @param bodies null for those without any
   */
  TexelBoxes(@Nullable BodyCharts[] bodies) {
    this.bodies = bodies;
    first = new int[bodies.length + 1];
    for (int i = 0; i < bodies.length; i++) {
      BodyCharts charts = bodies[i];
      first[i + 1] = first[i] + (charts == null ? 0 : charts.charts());
    }
    int count = first[bodies.length];
    width = new int[count];
    height = new int[count];
    x = new int[count];
    y = new int[count];
  }

  /** The number of a body's first chart among those of all. */
  int first(int body) {
    return first[body];
  }

  int end(int body) {
    return first[body + 1];
  }

  /** Sizes a body's boxes; returns the texels they take, with gutters. */
  long size(int body, double density) {
    BodyCharts charts = bodies[body];
    long sum = 0;
    for (int i = first[body]; i < first[body + 1]; i++) {
      width[i] = texels(charts.width()[i - first[body]], density);
      height[i] = texels(charts.height()[i - first[body]], density);
      sum += (long) (width[i] + GUTTER) * (height[i] + GUTTER);
    }
    return sum;
  }

  /** Whether a body's boxes are of one texel each, as small as can be. */
  boolean least(int body) {
    return longest(body) <= 1;
  }

  /** The longest side of a body's boxes. */
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

  /** Where a chart's corner lies on its page, texels. */
  double column(int box, BodyCharts charts, int chart, int corner) {
    float wide = charts.width()[chart];
    return x[box] + width[box] * (wide > 0 ? charts.flat()[corner] / (double) wide : 0.5);
  }

  double row(int box, BodyCharts charts, int chart, int corner) {
    float high = charts.height()[chart];
    return y[box] + height[box] * (high > 0 ? charts.flat()[corner + 1] / (double) high : 0.5);
  }
}
