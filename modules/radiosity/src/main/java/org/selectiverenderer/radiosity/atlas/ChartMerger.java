package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;

/**
 * Merges small charts into larger neighbours onto whose plane all of their triangles project from
 * the front.
 */
final class ChartMerger {
  /** A chart is merged into one that is at least this many times larger. */
  private static final double LARGER = 2;

  private final TriangleAdjacency body;
  private final int[] chartOf;
  private final double[] axes;
  private final double crease;
  private final double wide;
  private final int[] head;
  private final int[] tail;
  private final int[] next;
  private final double[] areas;

  /**
   * @param chartOf number of the chart of each triangle; changed
   * @param axes projection axis of each chart: x, y, z
   * @param crease cosine of the dihedral angle beyond which an edge separates charts
   * @param wide cosine of the largest angle between a chart's axis and the normals of its triangles
   */
  ChartMerger(
      TriangleAdjacency body,
      int[] chartOf,
      int charts,
      double[] axes,
      double crease,
      double wide) {
    this.body = body;
    this.chartOf = chartOf;
    this.axes = axes;
    this.crease = crease;
    this.wide = wide;
    head = new int[charts];
    tail = new int[charts];
    next = new int[chartOf.length];
    areas = new double[charts];
    Arrays.fill(head, TriangleAdjacency.NONE);
    Arrays.fill(next, TriangleAdjacency.NONE);
    for (int i = 0; i < chartOf.length; i++) {
      int chart = chartOf[i];
      areas[chart] += body.area(i);
      if (head[chart] < 0) {
        head[chart] = i;
      } else {
        next[tail[chart]] = i;
      }
      tail[chart] = i;
    }
  }

  /** Merges charts, the smallest first. */
  void join() {
    int charts = head.length;
    long[] order = new long[charts];
    for (int chart = 0; chart < charts; chart++) {
      order[chart] = (long) Float.floatToIntBits((float) areas[chart]) << 32 | chart;
    }
    Arrays.sort(order);
    double[] border = new double[charts];
    int[] beside = new int[16];
    for (long entry : order) {
      int chart = (int) entry;
      int count = 0;
      for (int i = head[chart]; i >= 0; i = next[i]) {
        for (int edge = 0; edge < 3; edge++) {
          int other = body.neighbour(i, edge);
          if (other < 0 || chartOf[other] == chart || body.facing(i, other) <= crease) {
            continue;
          }
          int with = chartOf[other];
          if (border[with] == 0) {
            beside = count == beside.length ? Arrays.copyOf(beside, 2 * count) : beside;
            beside[count++] = with;
          }
          border[with] += Math.max(body.edgeLength(i, edge), Double.MIN_NORMAL);
        }
      }
      int best = TriangleAdjacency.NONE;
      for (int k = 0; k < count; k++) {
        int with = beside[k];
        if (areas[with] >= LARGER * areas[chart]
            && (best < 0 || border[with] > border[best])
            && sees(with, chart)) {
          best = with;
        }
      }
      for (int k = 0; k < count; k++) {
        border[beside[k]] = 0;
      }
      if (best >= 0) {
        move(chart, best);
      }
    }
  }

  private boolean sees(int chart, int other) {
    double x = axes[3 * chart];
    double y = axes[3 * chart + 1];
    double z = axes[3 * chart + 2];
    for (int i = head[other]; i >= 0; i = next[i]) {
      if (body.facing(i, x, y, z) <= wide) {
        return false;
      }
    }
    return true;
  }

  private void move(int from, int to) {
    for (int i = head[from]; i >= 0; i = next[i]) {
      chartOf[i] = to;
    }
    next[tail[to]] = head[from];
    tail[to] = tail[from];
    areas[to] += areas[from];
    head[from] = TriangleAdjacency.NONE;
  }
}
