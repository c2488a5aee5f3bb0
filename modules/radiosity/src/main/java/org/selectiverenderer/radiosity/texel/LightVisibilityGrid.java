package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.atlas.AtlasPage;

/**
 * The results of the first shadow rays to a lamp: its visible share at the texels of a grid, every
 * fourth texel of every fourth row, and single rays at texels in between. Decides at which other
 * texels the share can be interpolated from them. One per thread, over an array of shares common to
 * all threads; works on one texel at a time.
 */
final class LightVisibilityGrid {
  /** Distance of grid texels. */
  static final int STEP = 4;

  /** The stored value of the share 1; larger values mark texels without a share. */
  static final int WHOLE = 60_000;

  static final char UNKNOWN = 65_535;
  static final char DARK = 65_534;

  /** Least number of single rays that together are as reliable as a grid texel. */
  private static final int ENOUGH = 6;

  /** Shares that differ by less count as equal. */
  private static final double SAME = 0.02;

  /** Change of the share over a cell above which it is not interpolated. */
  private static final double STEEP = 0.12;

  /**
   * Difference of the shares of adjacent texels up to which it counts as noise and not as a shadow
   * edge.
   */
  private static final double ALIKE = 0.2;

  /**
   * Largest difference between the mean of single rays and the interpolated share, in standard
   * errors.
   */
  private static final double AGREES = 2.5;

  private final TexelIndex texels;
  private final char[] shares;
  private int page = -1;
  private int first;
  private AtlasPage map = new AtlasPage(0, 0, new int[0], new float[0], new float[0], new int[0]);
  private int x;
  private int y;
  private int chart;

  // The interpolated share of the present texel, and whether its cell has any grid texel.
  private double interpolated;
  private boolean cornered;

  /**
   * @param shares of all texels, as {@link #of} encodes them, or one of the marks
   */
  LightVisibilityGrid(TexelIndex texels, char[] shares) {
    this.texels = texels;
    this.shares = shares;
  }

  /** Encodes a share from 0 to 1, or {@link LightVisibilityEstimator#NOTHING}. */
  static char of(double share) {
    return share == LightVisibilityEstimator.NOTHING
        ? DARK
        : (char) Math.round(WHOLE * Math.min(1, share));
  }

  /** Returns whether an encoded share is that of a penumbra. */
  static boolean mixed(char share) {
    return share >= SAME * WHOLE && share <= (1 - SAME) * WHOLE;
  }

  /** Moves to a texel. */
  void go(int texel) {
    if (page < 0 || texel < first || texel >= first + map.texels()) {
      page = texels.pageOf(texel);
      first = texels.first(page);
      map = texels.map(page);
    }
    x = (texel - first) % map.width();
    y = (texel - first) / map.width();
    chart = map.chart()[texel - first];
  }

  /** Returns the first texel of the present texel's cell. */
  int cell() {
    return first + y / STEP * STEP * map.width() + x / STEP * STEP;
  }

  /** Returns the number of the present texel in its cell. */
  int inCell() {
    return y % STEP * STEP + x % STEP;
  }

  /** Returns the interpolated share, after {@link #interpolate} returned true. */
  double interpolated() {
    return interpolated;
  }

  /** Returns whether {@link #interpolate} found any grid texel. */
  boolean cornered() {
    return cornered;
  }

  /** Returns whether the texel is a grid texel with adjacent grid texels in its chart. */
  boolean onGrid() {
    return x % STEP == 0 && y % STEP == 0 && neighbours(x, y);
  }

  /** Returns whether a grid texel has an adjacent grid texel in the chart of the present texel. */
  private boolean neighbours(int atX, int atY) {
    return in(atX - STEP, atY) || in(atX + STEP, atY) || in(atX, atY - STEP) || in(atX, atY + STEP);
  }

  /**
   * Returns whether the texel needs no single ray, since its cell has a grid texel and every other
   * texel of the cell casts a ray.
   */
  boolean spared() {
    int x0 = x / STEP * STEP;
    int y0 = y / STEP * STEP;
    return (x + y) % 2 != 0 && in(x0, y0) && neighbours(x0, y0);
  }

  /**
   * Returns whether the rays of a grid texel are enough: no shadow edge is near, or all rays were
   * cast already.
   */
  boolean settled() {
    char share = at(x, y);
    boolean hidden = share < SAME * WHOLE;
    boolean mixed = !hidden && share < (1 - SAME) * WHOLE;
    return share < DARK && (mixed || allSay(hidden));
  }

  /** Returns the known share of the texel, from 0 to 1. */
  double known() {
    return (double) at(x, y) / WHOLE;
  }

  /** Interpolates the share from the texels around; returns whether they determine it. */
  boolean interpolate() {
    int x0 = x / STEP * STEP;
    int y0 = y / STEP * STEP;
    double low = 2;
    double high = -1;
    double sum = 0;
    double weights = 0;
    for (int k = 0; k < 4; k++) {
      int cx = x0 + (k & 1) * STEP;
      int cy = y0 + (k >> 1) * STEP;
      char share = at(cx, cy);
      if (share >= DARK) {
        continue;
      }
      double value = (double) share / WHOLE;
      double wx = 1 - Math.abs(x - cx) / (double) STEP;
      double wy = 1 - Math.abs(y - cy) / (double) STEP;
      low = Math.min(low, value);
      high = Math.max(high, value);
      sum += wx * wy * value;
      weights += wx * wy;
    }
    boolean whole = weights > 0.999;
    cornered = weights > 0;
    if (!(weights > 0)) {
      return say();
    }
    if (high - low > STEEP) {
      return false;
    }
    interpolated = sum / weights;
    boolean even = high < SAME || low > 1 - SAME;
    return even ? allSay(high < SAME) : whole && agree(x0, y0);
  }

  /**
   * Returns whether the rays of all texels around agree that the lamp is hidden, or that it is
   * visible.
   */
  private boolean allSay(boolean hidden) {
    for (int ny = y - 2; ny <= y + 2; ny++) {
      for (int nx = x - 2; nx <= x + 2; nx++) {
        char share = at(nx, ny);
        if (share < DARK && (hidden ? share > SAME * WHOLE : share < (1 - SAME) * WHOLE)) {
          return false;
        }
      }
    }
    return true;
  }

  /** Returns whether the single rays of a cell agree with the interpolated share of a penumbra. */
  private boolean agree(int x0, int y0) {
    double sum = 0;
    int count = 0;
    for (int cy = y0; cy < y0 + STEP; cy++) {
      for (int cx = x0; cx < x0 + STEP; cx++) {
        char share = at(cx, cy);
        if (share < DARK && (cx > x0 || cy > y0)) {
          sum += (double) share / WHOLE;
          count++;
        }
      }
    }
    double error = Math.sqrt(interpolated * (1 - interpolated) / Math.max(1, count));
    return count >= ENOUGH && Math.abs(sum / count - interpolated) < AGREES * error + SAME;
  }

  /** Derives the share from single rays only, where the cell has no grid texel. */
  private boolean say() {
    int count = 0;
    int seen = 0;
    for (int ny = y - 2; ny <= y + 2; ny++) {
      for (int nx = x - 2; nx <= x + 2; nx++) {
        char share = at(nx, ny);
        count += share < DARK ? 1 : 0;
        seen += share < DARK && share > (1 - SAME) * WHOLE ? 1 : 0;
      }
    }
    interpolated = seen == 0 ? 0 : 1;
    return count >= ENOUGH && (seen == count || seen == 0 && allSay(true));
  }

  /**
   * Returns the mean share of the texel, which is known, and of the adjacent texels with about the
   * same share.
   */
  double meanOfAlike() {
    char own = at(x, y);
    double sum = 0;
    int count = 0;
    for (int ny = y - 1; ny <= y + 1; ny++) {
      for (int nx = x - 1; nx <= x + 1; nx++) {
        char share = at(nx, ny);
        if (share < DARK && Math.abs(share - own) <= ALIKE * WHOLE) {
          sum += share;
          count++;
        }
      }
    }
    return sum / count / WHOLE;
  }

  private char at(int atX, int atY) {
    return in(atX, atY) ? shares[first + atY * map.width() + atX] : UNKNOWN;
  }

  /** Returns whether a position is a texel of the present texel's chart. */
  private boolean in(int atX, int atY) {
    return atX >= 0
        && atY >= 0
        && atX < map.width()
        && atY < map.height()
        && map.chart()[atY * map.width() + atX] == chart;
  }
}
