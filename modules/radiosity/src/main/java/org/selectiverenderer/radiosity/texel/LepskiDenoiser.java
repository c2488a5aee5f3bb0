package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;

/**
 * Denoises irradiance records by local polynomial regression: each record is replaced by the value
 * of a plane or paraboloid fitted to the records around it, in the widest window whose fit agrees
 * with all narrower ones within their noise (Lepski's rule: Lepski 1990; Goldenshluger and
 * Nemirovski 1997; for images Katkovnik, Foi et al. 2004). Where light changes, the window extends
 * along the lines of equal light only. Weights do not depend on the values, so the filter has no
 * bias on the mean. One per thread.
 */
final class LepskiDenoiser {
  /** Factor from one window width to the next, and number of widths after the first. */
  private static final double WIDER = 1.5;

  private static final int TRIES = 4;

  /** Number of standard errors by which a wider fit may differ from each narrower one. */
  private static final double AGREES = 1;

  /**
   * Number of records in a window beyond which no wider one is tried, since it would only cost
   * time.
   */
  private static final int PLENTY = 128;

  /** Least number of records for a paraboloid. */
  private static final int FEW = 12;

  /** Ridge of the regression, which keeps fits to few records flat. */
  private static final double RIDGE = 0.001;

  private final IrradianceCache records;
  private final NeighbourRecordSearch near;
  private final double[] across = new double[3];
  private final double[] along = new double[3];
  private final double[] widths = new double[TRIES + 1];
  private final int[] ends = new int[TRIES + 1];

  // The records around, in the order of the narrowest window that contains each.
  private int[] around = new int[64];
  private double[] x = new double[64];
  private double[] y = new double[64];
  private double[] base = new double[64];
  private double[] rays = new double[64];
  private double[] value = new double[64];
  private double[] weight = new double[64];
  private double[] share = new double[64];

  /**
   * Variance of one ray, pooled over the records around: a single record that is too bright by
   * chance also has a larger estimate of its own variance, and would be smoothed more than one that
   * is too dark.
   */
  private double variance;

  // The normal equations, of which the lower triangle is used, and their solution.
  private final double[][] matrix = new double[6][6];
  private final double[] solved = new double[6];
  private final double[] term = new double[6];
  private final double[] matrixSums = new double[2];

  // Value, standard error and slope of the last fit.
  private double there;
  private double error;
  private double slopeX;
  private double slopeY;

  /**
   * The denoised values of the last record; its error is correlated with those of its neighbours.
   */
  final IrradianceRecord out = new IrradianceRecord();

  LepskiDenoiser(IrradianceCache records, NeighbourRecordSearch.Places places) {
    this.records = records;
    near = new NeighbourRecordSearch(places, TRIES + 1);
  }

  /**
   * Denoises a record.
   *
   * @param reach upper limit of the first window's radius, metres
   * @param most upper limit of the radius of all windows, metres: records far away say little about
   *     this point
   * @param enough standard error below which no wider window is tried
   */
  void filter(int record, double reach, double most, double enough) {
    float[] all = records.numbers();
    int at = IrradianceCache.NUMBERS * record;
    double radius = Math.min(reach, all[at + IrradianceCache.RADIUS]);
    for (int k = 0; k <= TRIES; k++) {
      widths[k] = Math.max(radius, Math.min(most, radius * StrictMath.pow(WIDER, k)));
    }
    collect(record, at, radius);
    if (ends[TRIES] == 0) {
      keepAsItIs(at);
      return;
    }
    double low = Double.NEGATIVE_INFINITY;
    double high = Double.POSITIVE_INFINITY;
    int kept = 0;
    double best = radius;
    double ux = 1;
    double uy = 0;
    boolean straight = false;
    for (int k = 0; k <= TRIES; k++) {
      double wide = widths[k];
      if (k > 0 && ends[k] < FEW) {
        continue;
      }
      fit(ends[k], k == 0 ? 3 : 6, ux, uy, straight ? best : wide, wide);
      if (k > 0 && !(there >= low && there <= high)) {
        if (straight) {
          break;
        }
        // Back to the last accepted window, and from there on wider along the lines of equal light
        // only.
        fit(ends[kept], kept == 0 ? 3 : 6, 1, 0, best, best);
        double slope = Math.sqrt(slopeX * slopeX + slopeY * slopeY);
        if (!(slope > 0)) {
          break;
        }
        ux = slopeX / slope;
        uy = slopeY / slope;
        straight = true;
        k--;
        continue;
      }
      low = Math.max(low, there - AGREES * error);
      high = Math.min(high, there + AGREES * error);
      kept = k;
      best = straight ? best : wide;
      if (error <= enough || ends[k] > PLENTY || ends[TRIES] == ends[k]) {
        break;
      }
    }
    fit(ends[kept], kept == 0 ? 3 : 6, ux, uy, best, straight ? widths[kept] : best);
    write(at, ends[kept]);
  }

  /** Collects the records around, those of the narrowest window first. */
  private void collect(int record, int at, double radius) {
    near.find(record, widths);
    makeRoom(near.end(TRIES));
    float[] all = records.numbers();
    TangentFrame.of(all, at + IrradianceCache.NORMAL, across, along);
    int used = 0;
    int i = 0;
    for (int k = 0; k <= TRIES; k++) {
      for (; i < near.end(k); i++) {
        int other = near.record(i);
        if (note(at, IrradianceCache.NUMBERS * other, radius, used)) {
          around[used++] = other;
        }
      }
      ends[k] = used;
    }
    variance = 0;
    double sum = 0;
    for (int j = 0; j < used; j++) {
      double e = all[IrradianceCache.NUMBERS * around[j] + IrradianceCache.ERROR];
      variance += base[j] * rays[j] * e * e;
      sum += base[j];
    }
    variance /= sum;
  }

  private void makeRoom(int count) {
    if (count <= around.length) {
      return;
    }
    int more = Math.max(count, 2 * around.length);
    around = new int[more];
    x = new double[more];
    y = new double[more];
    base = new double[more];
    rays = new double[more];
    value = new double[more];
    weight = new double[more];
    share = new double[more];
  }

  /**
   * Stores the position of another record and its value extrapolated to this normal; returns false
   * if it is not valid here.
   */
  private boolean note(int at, int other, double radius, int to) {
    float[] all = records.numbers();
    double dx = (double) all[other] - all[at];
    double dy = (double) all[other + 1] - all[at + 1];
    double dz = (double) all[other + 2] - all[at + 2];
    double nx = all[at + 3];
    double ny = all[at + 4];
    double nz = all[at + 5];
    double ox = all[other + 3];
    double oy = all[other + 4];
    double oz = all[other + 5];
    boolean flat = all[at + IrradianceCache.FLAT] > 0 && all[other + IrradianceCache.FLAT] > 0;
    if (!SameSurfaceCriterion.may(dx, dy, dz, nx, ny, nz, ox, oy, oz, flat, radius)
        || NearbyWallPlanes.between(all, at + IrradianceCache.WALLS, dx, dy, dz)
        || NearbyWallPlanes.between(all, other + IrradianceCache.WALLS, -dx, -dy, -dz)) {
      return false;
    }
    double cosine = nx * ox + ny * oy + nz * oz;
    x[to] = dx * across[0] + dy * across[1] + dz * across[2];
    y[to] = dx * along[0] + dy * along[1] + dz * along[2];
    rays[to] = all[other + IrradianceCache.RAYS];
    base[to] =
        rays[to] * (cosine - SameSurfaceCriterion.TURNED) / (1 - SameSurfaceCriterion.TURNED);
    value[to] = 0;
    for (int c = 0; c < 3; c++) {
      value[to] += turned(all, other, c, nx - ox, ny - oy, nz - oz);
    }
    return true;
  }

  private static double turned(float[] all, int record, int c, double tx, double ty, double tz) {
    int turn = record + IrradianceCache.TURN + 3 * c;
    return all[record + IrradianceCache.LIGHT + c]
        + all[turn] * tx
        + all[turn + 1] * ty
        + all[turn + 2] * tz;
  }

  /**
   * Fits a polynomial: computes its value at this point, its standard error, its slope and the
   * weight of each record in the value. A wide plane would underestimate a local maximum of the
   * light, so wider windows fit a paraboloid.
   *
   * @param end number of the records used
   * @param terms number of terms of the polynomial: 3 for a plane, 6 for a paraboloid
   * @param ux with {@code uy} the direction in which the window has the radius {@code thin}
   * @param wide radius of the window in the other direction, metres
   */
  private void fit(int end, int terms, double ux, double uy, double thin, double wide) {
    for (double[] row : matrix) {
      Arrays.fill(row, 0);
    }
    for (int i = 0; i < end; i++) {
      terms(i, ux, uy, thin, wide);
      double left = Math.max(0, 1 - term[1] * term[1] - term[2] * term[2]);
      weight[i] = left * left * base[i];
      for (int row = 0; row < terms; row++) {
        for (int column = 0; column <= row; column++) {
          matrix[row][column] += weight[i] * term[row] * term[column];
        }
      }
    }
    solve(terms);
    there = 0;
    double squares = 0;
    double gx = 0;
    double gy = 0;
    for (int i = 0; i < end; i++) {
      terms(i, ux, uy, thin, wide);
      double sum = 0;
      for (int row = 0; row < terms; row++) {
        sum += solved[row] * term[row];
      }
      share[i] = weight[i] * sum;
      there += share[i] * value[i];
      squares += share[i] * share[i] / rays[i];
      gx += weight[i] * term[1] * value[i];
      gy += weight[i] * term[2] * value[i];
    }
    error = Math.sqrt(variance * squares);
    gx = (gx - there * matrixSums[0]) / thin;
    gy = (gy - there * matrixSums[1]) / wide;
    slopeX = gx * ux - gy * uy;
    slopeY = gx * uy + gy * ux;
  }

  private void terms(int i, double ux, double uy, double thin, double wide) {
    double px = (x[i] * ux + y[i] * uy) / thin;
    double py = (y[i] * ux - x[i] * uy) / wide;
    term[0] = 1;
    term[1] = px;
    term[2] = py;
    term[3] = px * px;
    term[4] = px * py;
    term[5] = py * py;
  }

  /** Solves the normal equations for the value at the centre, by Cholesky decomposition. */
  private void solve(int terms) {
    double whole = matrix[0][0];
    matrixSums[0] = matrix[1][0];
    matrixSums[1] = matrix[2][0];
    for (int row = 1; row < terms; row++) {
      matrix[row][row] += RIDGE * whole;
    }
    for (int row = 0; row < terms; row++) {
      for (int column = 0; column <= row; column++) {
        double sum = matrix[row][column];
        for (int k = 0; k < column; k++) {
          sum -= matrix[row][k] * matrix[column][k];
        }
        matrix[row][column] = row == column ? Math.sqrt(sum) : sum / matrix[column][column];
      }
    }
    for (int row = 0; row < terms; row++) {
      double sum = row == 0 ? 1 : 0;
      for (int k = 0; k < row; k++) {
        sum -= matrix[row][k] * solved[k];
      }
      solved[row] = sum / matrix[row][row];
    }
    for (int row = terms - 1; row >= 0; row--) {
      double sum = solved[row];
      for (int k = row + 1; k < terms; k++) {
        sum -= matrix[k][row] * solved[k];
      }
      solved[row] = sum / matrix[row][row];
    }
  }

  /**
   * Copies the record unchanged: on a degenerate triangle, whose normal or radius is 0, not even
   * the record itself is in the window.
   */
  private void keepAsItIs(int at) {
    float[] all = records.numbers();
    for (int c = 0; c < 3; c++) {
      out.light[c] = all[at + IrradianceCache.LIGHT + c];
    }
    for (int k = 0; k < 9; k++) {
      out.turn[k] = all[at + IrradianceCache.TURN + k];
    }
    out.error = all[at + IrradianceCache.ERROR];
  }

  private void write(int at, int end) {
    float[] all = records.numbers();
    Arrays.fill(out.light, 0);
    Arrays.fill(out.turn, 0);
    double sum = 0;
    for (int i = 0; i < end; i++) {
      int other = IrradianceCache.NUMBERS * around[i];
      double tx = (double) all[at + 3] - all[other + 3];
      double ty = (double) all[at + 4] - all[other + 4];
      double tz = (double) all[at + 5] - all[other + 5];
      for (int c = 0; c < 3; c++) {
        out.light[c] += share[i] * turned(all, other, c, tx, ty, tz);
      }
      for (int k = 0; k < 9; k++) {
        out.turn[k] += weight[i] * all[other + IrradianceCache.TURN + k];
      }
      sum += weight[i];
    }
    for (int k = 0; k < 9; k++) {
      out.turn[k] /= sum;
    }
    for (int c = 0; c < 3; c++) {
      out.light[c] = Math.max(0, out.light[c]);
    }
    out.error = error;
  }
}
