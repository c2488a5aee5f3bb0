package org.selectiverenderer.base.picture;

/**
 * PNG's filters (ISO/IEC 15948, clause 9) of three bytes per pixel: each row has the one that
 * leaves the least sum of differences (12.8), which deflates best.
 */
final class PngFilters {
  private static final int PIXEL = 3;
  private static final int FILTERS = 5;

  private PngFilters() {}

  /**
   * Every row, its filter's number before it.
   *
   * @param row bytes of one
   */
  static byte[] filtered(int row, int height, byte[] rgb) {
    byte[] out = new byte[(row + 1) * height];
    byte[] tried = new byte[row];
    byte[] best = new byte[row];
    for (int y = 0; y < height; y++) {
      long least = Long.MAX_VALUE;
      for (int filter = 0; filter < FILTERS; filter++) {
        long sum = filter(filter, rgb, y * row, row, tried);
        if (sum < least) {
          least = sum;
          out[y * (row + 1)] = (byte) filter;
          byte[] other = best;
          best = tried;
          tried = other;
        }
      }
      System.arraycopy(best, 0, out, y * (row + 1) + 1, row);
    }
    return out;
  }

  /** Filters a row; returns the sum of what is left, as signed bytes. */
  private static long filter(int filter, byte[] all, int from, int row, byte[] out) {
    long sum = 0;
    for (int i = 0; i < row; i++) {
      int left = i < PIXEL ? 0 : all[from + i - PIXEL] & 0xff;
      int above = from == 0 ? 0 : all[from + i - row] & 0xff;
      int corner = from == 0 || i < PIXEL ? 0 : all[from + i - row - PIXEL] & 0xff;
      int guess =
          switch (filter) {
            case 1 -> left;
            case 2 -> above;
            case 3 -> (left + above) / 2;
            case 4 -> paeth(left, above, corner);
            default -> 0;
          };
      out[i] = (byte) (all[from + i] - guess);
      sum += Math.abs(out[i]);
    }
    return sum;
  }

  private static int paeth(int left, int above, int corner) {
    int guess = left + above - corner;
    int a = Math.abs(guess - left);
    int b = Math.abs(guess - above);
    int c = Math.abs(guess - corner);
    if (a <= b && a <= c) {
      return left;
    }
    return b <= c ? above : corner;
  }
}
