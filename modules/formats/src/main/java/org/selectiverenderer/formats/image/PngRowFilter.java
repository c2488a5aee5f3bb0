package org.selectiverenderer.formats.image;

/**
 * Applies PNG's row filters (ISO/IEC 15948, clause 9). Each row gets the filter with the least sum
 * of absolute differences (clause 12.8), which usually compresses best.
 */
final class PngRowFilter {
  private static final int FILTERS = 5;

  private PngRowFilter() {}

  /**
   * Returns the filtered rows, each preceded by the number of its filter.
   *
   * @param row bytes per row
   * @param pixel bytes per pixel
   */
  static byte[] filtered(int row, int height, int pixel, byte[] samples) {
    byte[] out = new byte[(row + 1) * height];
    byte[] tried = new byte[row];
    byte[] best = new byte[row];
    for (int y = 0; y < height; y++) {
      long least = Long.MAX_VALUE;
      for (int filter = 0; filter < FILTERS; filter++) {
        long sum = filter(filter, samples, y * row, row, pixel, tried);
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

  /** Filters a row into {@code out}; returns the sum of absolute differences as signed bytes. */
  private static long filter(int filter, byte[] all, int from, int row, int pixel, byte[] out) {
    long sum = 0;
    for (int i = 0; i < row; i++) {
      int left = i < pixel ? 0 : all[from + i - pixel] & 0xff;
      int above = from == 0 ? 0 : all[from + i - row] & 0xff;
      int corner = from == 0 || i < pixel ? 0 : all[from + i - row - pixel] & 0xff;
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
