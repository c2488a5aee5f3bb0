package org.selectiverenderer.radiosity.atlas;

/**
 * Packs rectangles into a strip of fixed width by the skyline bottom-left rule: each lies as low as
 * it fits and then as far left, and only the upper outline of the filled part is kept (Jylänki
 * 2010, "A Thousand Ways to Pack the Bin").
 */
final class SkylinePacker {
  private final int width;
  private final int[] left;
  private final int[] top;
  private int steps = 1;
  private int height;
  private int x;
  private int y;

  SkylinePacker(int width) {
    this.width = width;
    left = new int[width + 2];
    top = new int[width + 2];
  }

  /** Places a rectangle no wider than the strip. */
  void place(int w, int h) {
    int best = 0;
    y = Integer.MAX_VALUE;
    for (int i = 0; i < steps && left[i] + w <= width; i++) {
      if (top[i] >= y) {
        continue;
      }
      int over = top[i];
      for (int k = i + 1; k < steps && left[k] < left[i] + w && over < y; k++) {
        over = Math.max(over, top[k]);
      }
      if (over < y) {
        y = over;
        best = i;
      }
    }
    x = left[best];
    raise(best, x + w, y + h);
    height = Math.max(height, y + h);
  }

  /** Returns the left side of the last rectangle. */
  int x() {
    return x;
  }

  int y() {
    return y;
  }

  /** Returns the height up to which the strip is filled. */
  int height() {
    return height;
  }

  /** Replaces the steps of the skyline from {@code first} up to {@code right} by one step. */
  private void raise(int first, int right, int to) {
    int after = first;
    while (after < steps && end(after) <= right) {
      after++;
    }
    int begin = left[first];
    if (after < steps && left[after] < right) {
      left[after] = right;
    }
    // The new step takes the place of those from first up to after.
    int shift = first + 1 - after;
    if (shift != 0) {
      System.arraycopy(left, after, left, after + shift, steps - after);
      System.arraycopy(top, after, top, after + shift, steps - after);
      steps += shift;
    }
    left[first] = begin;
    top[first] = to;
    if (first + 1 < steps && top[first + 1] == to) {
      remove(first + 1);
    }
    if (first > 0 && top[first - 1] == to) {
      remove(first);
    }
  }

  private int end(int step) {
    return step + 1 < steps ? left[step + 1] : width;
  }

  private void remove(int step) {
    System.arraycopy(left, step + 1, left, step, steps - step - 1);
    System.arraycopy(top, step + 1, top, step, steps - step - 1);
    steps--;
  }
}
