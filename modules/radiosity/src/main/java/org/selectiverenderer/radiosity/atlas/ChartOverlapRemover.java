package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;

/**
 * Removes overlaps from charts: where the projection of a chart along its axis overlaps itself, as
 * for a ramp that winds up or a surface that was drawn twice, the later of two overlapping
 * triangles is taken out of the chart.
 */
final class ChartOverlapRemover {
  /** Tolerance of rounding, as a share of the size of coordinates. */
  private static final double ROUNDING = 1e-6;

  /** Largest number of grid cells along a side. */
  private static final int MOST_CELLS = 512;

  /**
   * Limit of tested pairs: so many per triangle, and a constant. A chart beyond it is cut into
   * single triangles; fans of some thousand triangles meet in one cell.
   */
  private static final long PAIRS = 400;

  private static final long SOME_PAIRS = 4_000_000;

  private final TriangleAdjacency body;
  private final int[] chartOf;
  private final double[] axes;
  private final ChartProjection plane;
  private final TriangleScanConverter rows = new TriangleScanConverter();
  private double[] flat = {};
  private double slack;

  ChartOverlapRemover(TriangleAdjacency body, int[] chartOf, double[] axes) {
    this.body = body;
    this.chartOf = chartOf;
    this.axes = axes;
    plane = new ChartProjection(body);
  }

  /**
   * Checks the charts from {@code from} up to {@code to}, exclusive; returns the number of
   * triangles taken out.
   */
  int evict(int from, int to) {
    int[] first = new int[to - from + 1];
    for (int chart : chartOf) {
      if (chart >= from) {
        first[chart - from + 1]++;
      }
    }
    for (int i = 1; i < first.length; i++) {
      first[i] += first[i - 1];
    }
    int[] members = new int[first[first.length - 1]];
    int[] at = first.clone();
    for (int i = 0; i < chartOf.length; i++) {
      if (chartOf[i] >= from) {
        members[at[chartOf[i] - from]++] = i;
      }
    }
    int evicted = 0;
    for (int chart = from; chart < to; chart++) {
      int begin = first[chart - from];
      int end = first[chart - from + 1];
      if (end - begin > 2) {
        evicted += chart(Arrays.copyOfRange(members, begin, end), chart);
      }
    }
    return evicted;
  }

  private int chart(int[] members, int chart) {
    int count = members.length;
    plane.face(axes, 3 * chart);
    flat = new double[6 * count];
    double[] box = box(members);
    double size = Math.max(box[2] - box[0], box[3] - box[1]);
    slack = ROUNDING * (size + reach(members[0]));
    int cells = Math.min(MOST_CELLS, (int) Math.ceil(Math.sqrt(count)));
    double scaleX = box[2] > box[0] ? cells / (box[2] - box[0]) : 0;
    double scaleY = box[3] > box[1] ? cells / (box[3] - box[1]) : 0;
    for (int i = 0; i < flat.length; i += 2) {
      flat[i] -= box[0];
      flat[i + 1] -= box[1];
    }
    int[] starts = new int[cells * cells + 1];
    for (int i = 0; i < count; i++) {
      insert(i, members, cells, scaleX, scaleY, starts, null);
    }
    for (int i = 1; i < starts.length; i++) {
      starts[i] += starts[i - 1];
    }
    int[] items = new int[starts[starts.length - 1]];
    int[] next = starts.clone();
    for (int i = 0; i < count; i++) {
      insert(i, members, cells, scaleX, scaleY, next, items);
    }
    return pairs(members, starts, items);
  }

  private double[] box(int[] members) {
    double[] box = {
      Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
      Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY
    };
    for (int i = 0; i < members.length; i++) {
      for (int corner = 0; corner < 3; corner++) {
        double x = plane.x(members[i], corner);
        double y = plane.y(members[i], corner);
        flat[6 * i + 2 * corner] = x;
        flat[6 * i + 2 * corner + 1] = y;
        box[0] = Math.min(box[0], x);
        box[1] = Math.min(box[1], y);
        box[2] = Math.max(box[2], x);
        box[3] = Math.max(box[3], y);
      }
    }
    return box;
  }

  private double reach(int triangle) {
    double most = 0;
    for (int axis = 0; axis < 3; axis++) {
      most = Math.max(most, Math.abs(body.coordinate(triangle, 0, axis)));
    }
    return most;
  }

  /**
   * Counts the cells that a triangle touches in {@code slots}, shifted by one, or stores the
   * triangle in each of them if {@code items} is given (counting sort).
   */
  private void insert(
      int i,
      int[] members,
      int cells,
      double scaleX,
      double scaleY,
      int[] slots,
      int @org.jspecify.annotations.Nullable [] items) {
    if (body.thin(members[i])) {
      return;
    }
    int at = 6 * i;
    rows.set(
        flat[at] * scaleX,
        flat[at + 1] * scaleY,
        flat[at + 2] * scaleX,
        flat[at + 3] * scaleY,
        flat[at + 4] * scaleX,
        flat[at + 5] * scaleY);
    int low = Math.min(cells - 1, (int) rows.bottom());
    int high = Math.min(cells - 1, (int) rows.top());
    for (int row = low; row <= high; row++) {
      if (!rows.row(row, row + 1.0)) {
        continue;
      }
      int left = Math.max(0, Math.min(cells - 1, (int) rows.from()));
      int right = Math.min(cells - 1, (int) rows.to());
      for (int column = left; column <= right; column++) {
        int cell = row * cells + column;
        if (items == null) {
          slots[cell + 1]++;
        } else {
          items[slots[cell]++] = i;
        }
      }
    }
  }

  private int pairs(int[] members, int[] starts, int[] items) {
    long looked = 0;
    int evicted = 0;
    for (int cell = 0; cell + 1 < starts.length; cell++) {
      for (int i = starts[cell]; i < starts[cell + 1]; i++) {
        int a = items[i];
        for (int j = starts[cell]; j < i && chartOf[members[a]] >= 0; j++) {
          int b = items[j];
          if (chartOf[members[b]] < 0 || beside(members[a], members[b])) {
            continue;
          }
          if (++looked > SOME_PAIRS + PAIRS * members.length) {
            return evicted + giveUp(members);
          }
          if (!apart(6 * a, 6 * b) && !apart(6 * b, 6 * a)) {
            chartOf[members[Math.max(a, b)]] = TriangleAdjacency.NONE;
            evicted++;
          }
        }
      }
    }
    return evicted;
  }

  private int giveUp(int[] members) {
    int evicted = 0;
    for (int i = 1; i < members.length; i++) {
      if (chartOf[members[i]] >= 0) {
        chartOf[members[i]] = TriangleAdjacency.NONE;
        evicted++;
      }
    }
    return evicted;
  }

  /** Returns whether two triangles share an edge; both face the axis, so they cannot overlap. */
  private boolean beside(int a, int b) {
    return body.neighbour(a, 0) == b || body.neighbour(a, 1) == b || body.neighbour(a, 2) == b;
  }

  /**
   * Returns whether some edge of the first, counter-clockwise triangle separates it from the second
   * one.
   */
  private boolean apart(int a, int b) {
    for (int i = 0; i < 3; i++) {
      int from = a + 2 * i;
      int to = a + 2 * ((i + 1) % 3);
      double dx = flat[to] - flat[from];
      double dy = flat[to + 1] - flat[from + 1];
      double border = slack * (Math.abs(dx) + Math.abs(dy));
      boolean outside = true;
      for (int k = 0; k < 3 && outside; k++) {
        int q = b + 2 * k;
        outside = dx * (flat[q + 1] - flat[from + 1]) - dy * (flat[q] - flat[from]) <= border;
      }
      if (outside) {
        return true;
      }
    }
    return false;
  }
}
