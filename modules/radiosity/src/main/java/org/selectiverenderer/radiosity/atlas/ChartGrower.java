package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;

/**
 * Segments a body into charts by region growing. Flat regions are seeds, the largest first; each
 * chart grows over edges without a crease onto triangles whose normals turn away from its axis by
 * less than {@link #CONE}, so that a round body falls into a few charts. Curved surfaces begin
 * where they face along a coordinate axis. Small charts left between are merged into their largest
 * neighbour, up to {@link #WIDE}: projected along its axis a chart stretches by 2 at most and none
 * of its triangles turns over.
 */
final class ChartGrower {
  private static final double FLAT = StrictMath.cos(StrictMath.toRadians(0.8));
  private static final double CREASE = StrictMath.cos(StrictMath.toRadians(40));
  private static final double CONE = StrictMath.cos(StrictMath.toRadians(46));
  private static final double WIDE = 0.5;

  /** Flat regions of at least this share of a body's area are seeds before all others. */
  private static final double LARGE = 0.02;

  /**
   * Number of times that charts which overlap themselves are cut; then each overlapping triangle
   * becomes a chart of its own.
   */
  private static final int ROUNDS = 6;

  private final TriangleAdjacency body;
  private final int[] chartOf;
  private final int[] queue;
  private final int[] regionOf;
  private double[] axes = new double[48];
  private int charts;

  ChartGrower(TriangleAdjacency body) {
    this.body = body;
    int count = body.triangles();
    chartOf = new int[count];
    queue = new int[count];
    regionOf = new int[count];
    Arrays.fill(chartOf, TriangleAdjacency.NONE);
  }

  /** Grows all charts; the other methods may be called afterwards only. */
  void grow() {
    long[] seeds = regions();
    for (int round = 0; ; round++) {
      int before = charts;
      for (long seed : seeds) {
        int triangle = (int) seed;
        if (chartOf[triangle] < 0) {
          flood(triangle);
        }
      }
      for (int i = 0; i < chartOf.length; i++) {
        if (chartOf[i] < 0) {
          flood(i);
        }
      }
      if (round == 0) {
        new ChartMerger(body, chartOf, charts, axes, CREASE, WIDE).join();
      }
      int evicted = new ChartOverlapRemover(body, chartOf, axes).evict(before, charts);
      if (evicted == 0) {
        break;
      }
      if (round == ROUNDS) {
        alone();
        break;
      }
    }
    renumber();
  }

  int[] chartOf() {
    return chartOf;
  }

  int charts() {
    return charts;
  }

  /** Returns the projection axis of each chart, a unit vector: x, y, z per chart. */
  double[] axes() {
    return axes;
  }

  /**
   * Finds the flat regions; returns one seed triangle of each, in the order in which charts grow.
   */
  private long[] regions() {
    int count = body.triangles();
    Arrays.fill(regionOf, TriangleAdjacency.NONE);
    double[] areas = new double[16];
    int[] seeds = new int[16];
    int regions = 0;
    double all = 0;
    for (int i = 0; i < count; i++) {
      if (regionOf[i] >= 0 || body.thin(i)) {
        continue;
      }
      if (regions == areas.length) {
        areas = Arrays.copyOf(areas, 2 * regions);
        seeds = Arrays.copyOf(seeds, 2 * regions);
      }
      seeds[regions] = i;
      areas[regions] = flat(i, regions);
      all += areas[regions];
      regions++;
    }
    long[] order = new long[regions];
    for (int r = 0; r < regions; r++) {
      int seed = seeds[r];
      double first =
          areas[r] > LARGE * all
              ? 2 + areas[r] / all
              : Math.max(
                  Math.abs(body.normal(seed, 0)),
                  Math.max(Math.abs(body.normal(seed, 1)), Math.abs(body.normal(seed, 2))));
      // Positive floats compare as their bits do.
      order[r] = (long) (Integer.MAX_VALUE - Float.floatToIntBits((float) first)) << 32 | seed;
    }
    Arrays.sort(order);
    return order;
  }

  private double flat(int seed, int region) {
    int size = 1;
    queue[0] = seed;
    regionOf[seed] = region;
    double area = 0;
    for (int at = 0; at < size; at++) {
      int triangle = queue[at];
      area += body.area(triangle);
      for (int edge = 0; edge < 3; edge++) {
        int next = body.neighbour(triangle, edge);
        if (next >= 0 && regionOf[next] < 0 && body.facing(seed, next) > FLAT) {
          regionOf[next] = region;
          queue[size++] = next;
        }
      }
    }
    return area;
  }

  private void flood(int seed) {
    int chart = charts++;
    if (3 * charts > axes.length) {
      axes = Arrays.copyOf(axes, 2 * axes.length);
    }
    double x = body.normal(seed, 0);
    double y = body.normal(seed, 1);
    double z = body.normal(seed, 2);
    double length = Math.sqrt(x * x + y * y + z * z);
    axes[3 * chart] = length > 0 ? x / length : 0;
    axes[3 * chart + 1] = length > 0 ? y / length : 0;
    axes[3 * chart + 2] = length > 0 ? z / length : 1;
    int size = 1;
    queue[0] = seed;
    chartOf[seed] = chart;
    for (int at = 0; at < size; at++) {
      int triangle = queue[at];
      for (int edge = 0; edge < 3; edge++) {
        int next = body.neighbour(triangle, edge);
        if (next >= 0
            && chartOf[next] < 0
            && (length > 0 || body.thin(next))
            && body.facing(triangle, next) > CREASE
            && body.facing(next, axes[3 * chart], axes[3 * chart + 1], axes[3 * chart + 2])
                > CONE) {
          chartOf[next] = chart;
          queue[size++] = next;
        }
      }
    }
  }

  private void alone() {
    for (int i = 0; i < chartOf.length; i++) {
      if (chartOf[i] < 0) {
        int chart = charts++;
        if (3 * charts > axes.length) {
          axes = Arrays.copyOf(axes, 2 * axes.length);
        }
        chartOf[i] = chart;
        for (int axis = 0; axis < 3; axis++) {
          axes[3 * chart + axis] = body.thin(i) && axis == 2 ? 1 : body.normal(i, axis);
        }
      }
    }
  }

  /**
   * Drops charts without triangles and numbers the others in the order of their first triangles.
   */
  private void renumber() {
    int[] renamed = new int[charts];
    Arrays.fill(renamed, TriangleAdjacency.NONE);
    double[] kept = new double[3 * charts];
    int next = 0;
    for (int i = 0; i < chartOf.length; i++) {
      int old = chartOf[i];
      if (renamed[old] < 0) {
        System.arraycopy(axes, 3 * old, kept, 3 * next, 3);
        renamed[old] = next++;
      }
      chartOf[i] = renamed[old];
    }
    charts = next;
    axes = Arrays.copyOf(kept, 3 * next);
  }
}
