package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;

/**
 * A body cut into charts and flattened: the chart of each triangle and its corners in the plane of
 * that chart.
 *
 * @param chartOf number of the chart of each triangle
 * @param flat x, y of the corners of each triangle in its chart, metres; the chart's bounding box
 *     begins at 0
 * @param width of each chart, metres; never below its height
 * @param height of each chart, metres
 */
record UvCharts(int[] chartOf, float[] flat, float[] width, float[] height) {
  /** Number of border edges along which the bounding box of a chart is tried. */
  private static final int TRIES = 6;

  int charts() {
    return width.length;
  }

  /** Returns the area of all flattened charts, square metres. */
  double area() {
    double sum = 0;
    for (int at = 0; at < flat.length; at += 6) {
      double cross =
          ((double) flat[at + 2] - flat[at]) * (flat[at + 5] - flat[at + 1])
              - ((double) flat[at + 3] - flat[at + 1]) * (flat[at + 4] - flat[at]);
      sum += Math.abs(cross) / 2;
    }
    return sum;
  }

  static UvCharts of(TriangleAdjacency body) {
    ChartGrower grower = new ChartGrower(body);
    grower.grow();
    int[] chartOf = grower.chartOf();
    int charts = grower.charts();
    UvCharts made =
        new UvCharts(chartOf, new float[6 * chartOf.length], new float[charts], new float[charts]);
    int[] first = new int[charts + 1];
    for (int chart : chartOf) {
      first[chart + 1]++;
    }
    for (int i = 0; i < charts; i++) {
      first[i + 1] += first[i];
    }
    int[] members = new int[chartOf.length];
    int[] at = Arrays.copyOf(first, charts);
    for (int i = 0; i < chartOf.length; i++) {
      members[at[chartOf[i]]++] = i;
    }
    ChartProjection plane = new ChartProjection(body);
    double[] xy = new double[6 * chartOf.length];
    for (int chart = 0; chart < charts; chart++) {
      plane.face(grower.axes(), 3 * chart);
      for (int i = first[chart]; i < first[chart + 1]; i++) {
        for (int corner = 0; corner < 3; corner++) {
          xy[6 * members[i] + 2 * corner] = plane.x(members[i], corner);
          xy[6 * members[i] + 2 * corner + 1] = plane.y(members[i], corner);
        }
      }
      made.lay(body, chart, Arrays.copyOfRange(members, first[chart], first[chart + 1]), xy);
    }
    return made;
  }

  /**
   * Rotates a chart so that its bounding box is the smallest of those along its longest border
   * edges.
   */
  private void lay(TriangleAdjacency body, int chart, int[] members, double[] xy) {
    double[] directions = borders(body, chart, members, xy);
    double[] best = {1, 0};
    double[] box = new double[4];
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < directions.length; i += 2) {
      double x = directions[i];
      double y = directions[i + 1];
      box(members, xy, x, y, box);
      double size = (box[2] - box[0]) * (box[3] - box[1]);
      if (size < least * (1 - 1e-6)) {
        least = size;
        best = new double[] {x, y};
      }
    }
    box(members, xy, best[0], best[1], box);
    if (box[3] - box[1] > box[2] - box[0]) {
      best = new double[] {-best[1], best[0]};
      box(members, xy, best[0], best[1], box);
    }
    width[chart] = (float) (box[2] - box[0]);
    height[chart] = (float) (box[3] - box[1]);
    for (int triangle : members) {
      for (int corner = 0; corner < 3; corner++) {
        int at = 6 * triangle + 2 * corner;
        double x = xy[at] * best[0] + xy[at + 1] * best[1] - box[0];
        double y = xy[at + 1] * best[0] - xy[at] * best[1] - box[1];
        flat[at] = Math.max(0, Math.min(width[chart], (float) x));
        flat[at + 1] = Math.max(0, Math.min(height[chart], (float) y));
      }
    }
  }

  /** Returns unit vectors along the longest border edges, and along the x axis. */
  private double[] borders(TriangleAdjacency body, int chart, int[] members, double[] xy) {
    double[] lengths = new double[TRIES];
    double[] directions = new double[2 * TRIES];
    int found = 0;
    for (int triangle : members) {
      for (int edge = 0; edge < 3; edge++) {
        int other = body.neighbour(triangle, edge);
        if (other >= 0 && chartOf[other] == chart) {
          continue;
        }
        int from = 6 * triangle + 2 * edge;
        int to = 6 * triangle + 2 * ((edge + 1) % 3);
        double dx = xy[to] - xy[from];
        double dy = xy[to + 1] - xy[from + 1];
        double length = Math.sqrt(dx * dx + dy * dy);
        if (!(length > 0) || found == TRIES && length <= lengths[TRIES - 1]) {
          continue;
        }
        int place = found == TRIES ? TRIES - 1 : found++;
        while (place > 0 && lengths[place - 1] < length) {
          lengths[place] = lengths[place - 1];
          directions[2 * place] = directions[2 * place - 2];
          directions[2 * place + 1] = directions[2 * place - 1];
          place--;
        }
        lengths[place] = length;
        directions[2 * place] = dx / length;
        directions[2 * place + 1] = dy / length;
      }
    }
    double[] all = Arrays.copyOf(directions, 2 * found + 2);
    all[2 * found] = 1;
    return all;
  }

  private static void box(int[] members, double[] xy, double x, double y, double[] box) {
    box[0] = Double.POSITIVE_INFINITY;
    box[1] = Double.POSITIVE_INFINITY;
    box[2] = Double.NEGATIVE_INFINITY;
    box[3] = Double.NEGATIVE_INFINITY;
    for (int triangle : members) {
      for (int at = 6 * triangle; at < 6 * triangle + 6; at += 2) {
        double along = xy[at] * x + xy[at + 1] * y;
        double across = xy[at + 1] * x - xy[at] * y;
        box[0] = Math.min(box[0], along);
        box[1] = Math.min(box[1], across);
        box[2] = Math.max(box[2], along);
        box[3] = Math.max(box[3], across);
      }
    }
  }
}
