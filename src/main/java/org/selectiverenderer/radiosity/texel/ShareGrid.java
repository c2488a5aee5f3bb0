package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.atlas.TexelMap;

/**
 * What the first rays to a lamp say: shares of its light that reach texels of a grid, every fourth
 * of every fourth row, and single rays on those in between. Tells where they say the share of a
 * texel too. One per thread, over shares that all have in common; looks at one texel at a time.
 */
final class ShareGrid {
  /** Texels from one of the grid to the next. */
  static final int STEP = 4;

  /** Units of a share, and marks for none. */
  static final int WHOLE = 60_000;

  static final char UNKNOWN = 65_535;
  static final char DARK = 65_534;

  /** Single rays that together are as good as those of a texel of the grid. */
  private static final int ENOUGH = 6;

  /** Shares that differ by less count as one. */
  private static final double SAME = 0.02;

  /** A share that changes by more over a cell is not interpolated. */
  private static final double STEEP = 0.12;

  /** Shares of texels side by side that differ by less do so by their noise, not by an edge. */
  private static final double ALIKE = 0.2;

  /** How far the mean of single rays may be from what is interpolated, in standard errors. */
  private static final double AGREES = 2.5;

  private final Texels texels;
  private final char[] shares;
  private int page = -1;
  private int first;
  private TexelMap map = new TexelMap(0, 0, new int[0], new float[0], new float[0], new int[0]);
  private int x;
  private int y;
  private int chart;

  // Of the texel looked at: its share by interpolation, and whether its cell has any of the grid.
  private double interpolated;
  private boolean cornered;

  /**
   * @param shares by all texels, as {@link #of} makes them, or one of the marks
   */
  ShareGrid(Texels texels, char[] shares) {
    this.texels = texels;
    this.shares = shares;
  }

  /** A share from 0 to 1, or {@link LampShadow#NOTHING}, in its units. */
  static char of(double share) {
    return share == LampShadow.NOTHING ? DARK : (char) Math.round(WHOLE * Math.min(1, share));
  }

  /** Whether a share is one of a half-shadow. */
  static boolean mixed(char share) {
    return share >= SAME * WHOLE && share <= (1 - SAME) * WHOLE;
  }

  /** Looks at a texel. */
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

  /** The first texel of the cell of the texel looked at. */
  int cell() {
    return first + y / STEP * STEP * map.width() + x / STEP * STEP;
  }

  /** The number of the texel looked at in its cell. */
  int inCell() {
    return y % STEP * STEP + x % STEP;
  }

  /** The share by interpolation, after {@link #interpolate} said that there is one. */
  double interpolated() {
    return interpolated;
  }

  /** Whether {@link #interpolate} met any texel of the grid. */
  boolean cornered() {
    return cornered;
  }

  /** Whether the texel is one of the grid, with others of it in its chart. */
  boolean onGrid() {
    return x % STEP == 0 && y % STEP == 0 && neighbours(x, y);
  }

  /** Whether there is another texel of the grid beside one, in the chart looked at. */
  private boolean neighbours(int atX, int atY) {
    return in(atX - STEP, atY) || in(atX + STEP, atY) || in(atX, atY - STEP) || in(atX, atY + STEP);
  }

  /** Whether the texel may go without a single ray: its cell has one of the grid, and others do. */
  boolean spared() {
    int x0 = x / STEP * STEP;
    int y0 = y / STEP * STEP;
    return (x + y) % 2 != 0 && in(x0, y0) && neighbours(x0, y0);
  }

  /** Whether the rays of a texel of the grid are enough: no edge is near, or it had them all. */
  boolean settled() {
    char share = at(x, y);
    boolean hidden = share < SAME * WHOLE;
    boolean mixed = !hidden && share < (1 - SAME) * WHOLE;
    return share < DARK && (mixed || allSay(hidden));
  }

  /** The share that is known of the texel, from 0 to 1. */
  double known() {
    return (double) at(x, y) / WHOLE;
  }

  /** Whether the texels around say what reaches this one. */
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

  /** Whether single rays around the texel all find the lamp hidden, or all see it. */
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

  /** Whether single rays of a cell are what a share in a half-shadow gives. */
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

  /** Likewise without any texel of the grid: the single rays must be all that is needed. */
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

  /** The mean share of the texel, which is known, and those around that have about the same. */
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

  /** Whether a place is a texel of the chart of the texel looked at. */
  private boolean in(int atX, int atY) {
    return atX >= 0
        && atY >= 0
        && atX < map.width()
        && atY < map.height()
        && map.chart()[atY * map.width() + atX] == chart;
  }
}
