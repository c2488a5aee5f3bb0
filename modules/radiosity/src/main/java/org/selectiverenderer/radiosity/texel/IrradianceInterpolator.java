package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;

/**
 * Interpolates the irradiance between records: fits a plane to the valid records nearby, weighted
 * by distance, after each was extrapolated to the normal asked for by its rotational gradient (Ward
 * and Heckbert 1992). Two surfaces through one point with one normal have the same irradiance
 * there. One per thread.
 */
final class IrradianceInterpolator {
  /** Ridge of the regression, which keeps planes through few records flat. */
  private static final double RIDGE = 0.003;

  /**
   * Share by which the interpolated light may exceed the brightest record around, or fall below the
   * darkest.
   */
  private static final double BEYOND = 0.15;

  private final IrradianceCache records;
  private final double[] box = new double[6];
  private final double[] across = new double[3];
  private final double[] along = new double[3];
  private int[] near = new int[64];
  private int count;
  private double[] weights = new double[64];
  private double[] values = new double[5 * 64];
  private int used;

  /** Irradiance r, g, b at the last point, lx. */
  final double[] light = new double[3];

  /** Sum of the records' weights at the last point; a record right there has the weight 1. */
  double weight;

  /** Root mean square deviation of the records from the plane, red, green and blue together. */
  double misfit;

  /** Standard error of the interpolated light. */
  double error;

  IrradianceInterpolator(IrradianceCache records) {
    this.records = records;
  }

  /** Begins without points to look up. */
  void begin() {
    Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
    Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
  }

  /** Includes a point that will be looked up. */
  void include(double[] point) {
    for (int axis = 0; axis < 3; axis++) {
      box[axis] = Math.min(box[axis], point[axis]);
      box[axis + 3] = Math.max(box[axis + 3], point[axis]);
    }
  }

  /** Finds the records for all points included. */
  void find() {
    count = 0;
    records.tree().overlap(box, this::keep);
  }

  private void keep(int record) {
    if (count == near.length) {
      near = Arrays.copyOf(near, 2 * count);
      weights = Arrays.copyOf(weights, 2 * count);
      values = Arrays.copyOf(values, 10 * count);
    }
    near[count++] = record;
  }

  /**
   * Interpolates at a point that was included; returns whether some record is valid there.
   *
   * @param flat whether the point is shaded flat
   * @param most largest distance of records, metres
   */
  boolean at(double[] point, double[] normal, boolean flat, int group, double most) {
    TangentFrame.of(normal, across, along);
    used = 0;
    weight = 0;
    error = 0;
    double radii = 0;
    for (int i = 0; i < count; i++) {
      if (records.groups()[near[i]] == group) {
        radii += weigh(near[i], point, normal, flat, most);
      }
    }
    if (used == 0) {
      return false;
    }
    error = (records.evened() ? error : Math.sqrt(error)) / weight;
    fit(weight / radii);
    return true;
  }

  /** Stores a record's weight, position and light, if it is valid; returns weight times radius. */
  private double weigh(int record, double[] point, double[] normal, boolean flat, double most) {
    float[] r = records.numbers();
    int at = IrradianceCache.NUMBERS * record;
    double dx = r[at] - point[0];
    double dy = r[at + 1] - point[1];
    double dz = r[at + 2] - point[2];
    double radius = Math.min(most, r[at + IrradianceCache.RADIUS]);
    double square = (dx * dx + dy * dy + dz * dz) / (radius * radius);
    if (square >= 1) {
      return 0;
    }
    double nx = r[at + 3];
    double ny = r[at + 4];
    double nz = r[at + 5];
    boolean bothFlat = flat && r[at + IrradianceCache.FLAT] > 0;
    if (!SameSurfaceCriterion.may(
            dx, dy, dz, nx, ny, nz, normal[0], normal[1], normal[2], bothFlat, radius)
        || NearbyWallPlanes.between(r, at + IrradianceCache.WALLS, -dx, -dy, -dz)) {
      return 0;
    }
    double cosine = nx * normal[0] + ny * normal[1] + nz * normal[2];
    double w = (1 - square) * (1 - square) * (cosine - SameSurfaceCriterion.TURNED);
    w /= 1 - SameSurfaceCriterion.TURNED;
    int to = 5 * used;
    values[to] = dx * across[0] + dy * across[1] + dz * across[2];
    values[to + 1] = dx * along[0] + dy * along[1] + dz * along[2];
    double tx = normal[0] - nx;
    double ty = normal[1] - ny;
    double tz = normal[2] - nz;
    for (int c = 0; c < 3; c++) {
      int turn = at + IrradianceCache.TURN + 3 * c;
      double turned = r[turn] * tx + r[turn + 1] * ty + r[turn + 2] * tz;
      values[to + 2 + c] = Math.max(0, r[at + IrradianceCache.LIGHT + c] + turned);
    }
    weights[used++] = w;
    weight += w;
    double e = w * r[at + IrradianceCache.ERROR];
    error += records.evened() ? e : e * e;
    return w * radius;
  }

  /**
   * @param scale inverse of the length that distances are measured in, 1/m
   */
  private void fit(double scale) {
    double a = 0;
    double b = 0;
    double aa = 0;
    double ab = 0;
    double bb = 0;
    for (int i = 0; i < used; i++) {
      double x = values[5 * i] * scale;
      double y = values[5 * i + 1] * scale;
      a += weights[i] * x;
      b += weights[i] * y;
      aa += weights[i] * x * x;
      ab += weights[i] * x * y;
      bb += weights[i] * y * y;
    }
    a /= weight;
    b /= weight;
    aa += weight * (RIDGE - a * a);
    bb += weight * (RIDGE - b * b);
    ab -= weight * a * b;
    double whole = aa * bb - ab * ab;
    double squares = 0;
    for (int c = 0; c < 3; c++) {
      double mean = 0;
      double av = 0;
      double bv = 0;
      double low = Double.POSITIVE_INFINITY;
      double high = 0;
      for (int i = 0; i < used; i++) {
        double v = values[5 * i + 2 + c];
        mean += weights[i] * v;
        av += weights[i] * v * values[5 * i] * scale;
        bv += weights[i] * v * values[5 * i + 1] * scale;
        low = Math.min(low, v);
        high = Math.max(high, v);
      }
      mean /= weight;
      av -= weight * a * mean;
      bv -= weight * b * mean;
      double ga = (bb * av - ab * bv) / whole;
      double gb = (aa * bv - ab * av) / whole;
      double there = mean - ga * a - gb * b;
      double least = low - BEYOND * low;
      light[c] = Math.max(least, Math.min(high + BEYOND * high, there));
      for (int i = 0; i < used; i++) {
        double x = values[5 * i] * scale - a;
        double y = values[5 * i + 1] * scale - b;
        double off = values[5 * i + 2 + c] - mean - ga * x - gb * y;
        squares += weights[i] * off * off;
      }
    }
    misfit = Math.sqrt(3 * squares / weight);
  }
}
