package org.selectiverenderer.render.occlusion;

import java.util.Arrays;

/**
 * A coarse depth buffer of an eye's view for occlusion culling: per cell, the depth beyond which
 * everything is hidden. A cell is hidden only where outlines cover all of it. It stores 1 / depth,
 * which is linear over the image of a plane; larger is nearer, 0 is infinitely far.
 *
 * <p>An outline covers a cell when none of its edges comes near the cell and the cell's row crosses
 * the outline an odd number of times up to the cell. Both conditions are bit sets with two words
 * per row: one of the cells near an edge, one that each crossing inverts from its cell on. Where
 * exactly within its cell an edge crosses does not matter, because that cell is near the edge.
 */
final class OcclusionBuffer {
  static final int COLUMNS = 128;
  static final int ROWS = 96;
  private static final int TILE = 8;
  private static final int TILE_COLUMNS = COLUMNS / TILE;

  /** Edges that rise less than this are treated as horizontal. */
  private static final double LEVEL = 1e-6;

  private final float[] hiddenFrom = new float[COLUMNS * ROWS];
  private final float[] tiles = new float[TILE_COLUMNS * (ROWS / TILE)];
  private final long[] near = new long[2 * ROWS];
  private final long[] inside = new long[2 * ROWS];
  private double marginX;
  private double marginY;
  private int firstRow;
  private int lastRow;

  /**
   * Clears the buffer.
   *
   * @param marginX the horizontal margin around edges, in cells
   * @param marginY the vertical margin, in cells
   */
  void clear(double marginX, double marginY) {
    this.marginX = marginX;
    this.marginY = marginY;
    Arrays.fill(hiddenFrom, 0);
    Arrays.fill(tiles, 0);
    beginOutline();
  }

  private void beginOutline() {
    firstRow = ROWS;
    lastRow = -1;
  }

  /**
   * Adds an edge to the outline that {@link #fill} ends; coordinates in cells from the lower left
   * corner.
   */
  void edge(double x0, double y0, double x1, double y1) {
    if (y0 > y1) {
      upward(x1, y1, x0, y0);
    } else {
      upward(x0, y0, x1, y1);
    }
  }

  private void upward(double x0, double y0, double x1, double y1) {
    int first = (int) Math.max(0, Math.floor(y0 - marginY));
    int last = (int) Math.min(ROWS - 1, Math.floor(y1 + marginY));
    open(first, last);
    double slope = y1 - y0 > LEVEL ? (x1 - x0) / (y1 - y0) : 0;
    for (int row = first; row <= last; row++) {
      double bottom = row - marginY;
      double top = row + 1 + marginY;
      double from = y0 >= bottom || slope == 0 ? x0 : x0 + (bottom - y0) * slope;
      double to = y1 <= top || slope == 0 ? x1 : x0 + (top - y0) * slope;
      block(row, Math.min(from, to) - marginX, Math.max(from, to) + marginX);
      double middle = row + 0.5;
      if (y0 <= middle && middle < y1) {
        double x = Math.max(0, x0 + (middle - y0) * slope);
        if (x < COLUMNS) {
          invert(row, (int) x);
        }
      }
    }
  }

  /** Clears rows that the outline touches for the first time. */
  private void open(int first, int last) {
    if (first > last) {
      return;
    }
    if (lastRow < firstRow) {
      firstRow = first;
      lastRow = first - 1;
    }
    if (first < firstRow) {
      Arrays.fill(near, 2 * first, 2 * firstRow, 0);
      Arrays.fill(inside, 2 * first, 2 * firstRow, 0);
      firstRow = first;
    }
    if (last > lastRow) {
      Arrays.fill(near, 2 * (lastRow + 1), 2 * (last + 1), 0);
      Arrays.fill(inside, 2 * (lastRow + 1), 2 * (last + 1), 0);
      lastRow = last;
    }
  }

  private void block(int row, double from, double to) {
    if (to < 0 || from >= COLUMNS) {
      return;
    }
    int first = (int) Math.max(0, from);
    int last = (int) Math.min(COLUMNS - 1, to);
    if (first < 64) {
      near[2 * row] |= (-1L << first) & (last < 63 ? ~(-1L << (last + 1)) : -1L);
    }
    if (last >= 64) {
      near[2 * row + 1] |=
          (first > 64 ? -1L << (first - 64) : -1L) & (last < 127 ? ~(-1L << (last - 63)) : -1L);
    }
  }

  private void invert(int row, int column) {
    if (column < 64) {
      inside[2 * row] ^= -1L << column;
      inside[2 * row + 1] ^= -1L;
    } else {
      inside[2 * row + 1] ^= -1L << (column - 64);
    }
  }

  /**
   * Ends an outline: everything behind its plane is hidden in the cells that it covers. The plane
   * is given as 1 / depth = a * x + b * y + c, in cells.
   *
   * @return the number of cells that it covers
   */
  int fill(double a, double b, double c) {
    // The farthest point of the plane within a cell and its margin.
    double farthest = c - Math.abs(a) * (0.5 + marginX) - Math.abs(b) * (0.5 + marginY);
    int covered = 0;
    for (int row = firstRow; row <= lastRow; row++) {
      double atRow = farthest + b * (row + 0.5) + a * 0.5;
      for (int word = 0; word < 2; word++) {
        long cells = inside[2 * row + word] & ~near[2 * row + word];
        while (cells != 0) {
          int first = Long.numberOfTrailingZeros(cells);
          int count = Long.numberOfTrailingZeros(~(cells >>> first));
          fill(row, 64 * word + first, count, atRow, a);
          covered += count;
          cells &= first + count < 64 ? -1L << (first + count) : 0;
        }
      }
    }
    beginOutline();
    return covered;
  }

  private void fill(int row, int first, int count, double atRow, double a) {
    int at = row * COLUMNS + first;
    for (int column = first; column < first + count; column++, at++) {
      float depth = (float) (atRow + a * column);
      if (depth > hiddenFrom[at]) {
        hiddenFrom[at] = depth;
      }
    }
  }

  /**
   * Computes the farthest depth of each tile, for quick queries; to be called after the last
   * outline.
   */
  void finish() {
    for (int tile = 0; tile < tiles.length; tile++) {
      int corner = tile / TILE_COLUMNS * TILE * COLUMNS + tile % TILE_COLUMNS * TILE;
      float farthest = Float.POSITIVE_INFINITY;
      for (int row = 0; row < TILE; row++) {
        for (int at = corner + row * COLUMNS, end = at + TILE; at < end; at++) {
          if (hiddenFrom[at] < farthest) {
            farthest = hiddenFrom[at];
          }
        }
      }
      tiles[tile] = farthest;
    }
  }

  /**
   * Returns whether an object within a rectangle that comes at most as near as {@code side} is
   * hidden. Outside of the view everything is hidden.
   */
  boolean hides(double minX, double minY, double maxX, double maxY, ConservativeDepthBound side) {
    int left = (int) Math.max(0, Math.floor(minX));
    int right = (int) Math.min(COLUMNS - 1, Math.floor(maxX));
    int bottom = (int) Math.max(0, Math.floor(minY));
    int top = (int) Math.min(ROWS - 1, Math.floor(maxY));
    for (int row = bottom; row <= top; ) {
      int nextRow = Math.min(top + 1, (row / TILE + 1) * TILE);
      for (int column = left; column <= right; ) {
        int next = Math.min(right + 1, (column / TILE + 1) * TILE);
        if (!tileHides(row / TILE, column / TILE, side)
            && !hides(row, nextRow, column, next, side)) {
          return false;
        }
        column = next;
      }
      row = nextRow;
    }
    return true;
  }

  private boolean tileHides(int row, int column, ConservativeDepthBound side) {
    double hidden = tiles[row * TILE_COLUMNS + column];
    double half = TILE / 2.0;
    return hidden > side.nearest()
        || (hidden > 0
            && side.slopes()
            && hidden > side.nearest(column * TILE + half, row * TILE + half, half));
  }

  private boolean hides(int fromRow, int toRow, int from, int to, ConservativeDepthBound side) {
    for (int row = fromRow; row < toRow; row++) {
      for (int column = from; column < to; column++) {
        float hidden = hiddenFrom[row * COLUMNS + column];
        if (!(hidden > 0 && hidden > side.nearest(column + 0.5, row + 0.5, 0.5))) {
          return false;
        }
      }
    }
    return true;
  }

  /**
   * Returns the depth beyond which a cell is hidden, as 1 / depth; 0 for a cell that hides nothing.
   */
  float hiddenFrom(int column, int row) {
    return hiddenFrom[row * COLUMNS + column];
  }
}
