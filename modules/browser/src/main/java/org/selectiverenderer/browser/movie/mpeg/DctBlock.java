package org.selectiverenderer.browser.movie.mpeg;

import java.util.Arrays;

/**
 * A block of 8 x 8 DCT coefficients: reads, dequantizes and inversely transforms them (ISO/IEC
 * 11172-2, 2.4.3.7 and 2.4.4). Reused for one block after the other.
 */
final class DctBlock {
  /** The positions of coefficients in coding order. */
  static final int[] ZIGZAG = {
    0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20,
    13, 6, 7, 14, 21, 28, 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59,
    52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47, 55, 62, 63
  };

  private static final int LARGEST = 2047;

  private final VlcTable code;
  private final float[] values = new float[64];

  /** The orthonormal cosine basis, [frequency * 8 + sample]. */
  private final float[] waves = new float[64];

  /**
   * @param code the code table of coefficients
   */
  DctBlock(VlcTable code) {
    this.code = code;
    for (int u = 0; u < 8; u++) {
      for (int x = 0; x < 8; x++) {
        double scale = u == 0 ? Math.sqrt(0.125) : 0.5;
        waves[8 * u + x] = (float) (scale * Math.cos((2 * x + 1) * u * Math.PI / 16));
      }
    }
  }

  /**
   * Reads an intra block whose DC coefficient is known.
   *
   * @param mean the DC coefficient: eight times the mean of the samples
   * @return whether the block could be read
   */
  boolean intra(BitReader bits, int mean, int quantizer, int[] weights) {
    Arrays.fill(values, 0);
    values[0] = mean;
    return read(bits, 0, 0, quantizer, weights);
  }

  /**
   * Reads a non-intra block: the difference to the prediction.
   *
   * @return whether the block could be read
   */
  boolean difference(BitReader bits, int quantizer, int[] weights) {
    Arrays.fill(values, 0);
    int from = -1;
    if (bits.peek(1) == 1) { // The first one has a shorter code: no end.
      bits.skip(1);
      from = 0;
      values[0] = value(bits.bit() ? -1 : 1, 1, quantizer, weights[0]);
    }
    return read(bits, from, 1, quantizer, weights);
  }

  /**
   * @param at the index in coding order of the last coefficient already present
   * @param more 1 if half a quantizer step is added to a level, else 0
   */
  private boolean read(BitReader bits, int at, int more, int quantizer, int[] weights) {
    int place = at;
    while (true) {
      int next = code.read(bits);
      int run;
      int level;
      if (next == MpegVlcTables.END) {
        return true;
      } else if (next == VlcTable.NONE) {
        return false;
      } else if (next == MpegVlcTables.ESCAPE) {
        run = bits.read(6);
        level = (byte) bits.read(8);
        if (level == 0) {
          level = bits.read(8);
        } else if (level == -128) {
          level = bits.read(8) - 256;
        }
      } else {
        run = next >> 6;
        level = bits.bit() ? -(next & 63) : next & 63;
      }
      place += run + 1;
      if (place > 63) {
        return false;
      }
      int to = ZIGZAG[place];
      values[to] = value(level, more, quantizer, weights[to]);
    }
  }

  /**
   * Dequantizes a level; the result is made odd, so that rounding errors of different decoders do
   * not accumulate.
   */
  private static int value(int level, int more, int quantizer, int weight) {
    int value = (2 * level + more * Integer.signum(level)) * quantizer * weight / 16;
    if ((value & 1) == 0) {
      value -= Integer.signum(value);
    }
    return Math.max(-LARGEST - 1, Math.min(LARGEST, value));
  }

  /**
   * Writes the samples to a plane.
   *
   * @param add whether they are added to the present samples
   */
  void put(byte[] plane, int at, int stride, boolean add) {
    for (int row = 0; row < 64; row += 8) {
      samples(row, 1);
    }
    for (int column = 0; column < 8; column++) {
      samples(column, 8);
    }
    for (int y = 0; y < 8; y++) {
      int to = at + y * stride;
      for (int x = 0; x < 8; x++, to++) {
        int value = Math.round(values[8 * y + x]) + (add ? plane[to] & 0xff : 0);
        plane[to] = (byte) Math.max(0, Math.min(255, value));
      }
    }
  }

  /**
   * Applies the one-dimensional inverse DCT to eight coefficients, using the symmetry of even and
   * odd basis functions.
   */
  private void samples(int from, int step) {
    float c0 = values[from];
    float c1 = values[from + step];
    float c2 = values[from + 2 * step];
    float c3 = values[from + 3 * step];
    float c4 = values[from + 4 * step];
    float c5 = values[from + 5 * step];
    float c6 = values[from + 6 * step];
    float c7 = values[from + 7 * step];
    if (c1 == 0 && c2 == 0 && c3 == 0 && c4 == 0 && c5 == 0 && c6 == 0 && c7 == 0) {
      for (int i = 0; i < 8; i++) {
        values[from + i * step] = c0 * waves[0];
      }
      return;
    }
    for (int x = 0; x < 4; x++) {
      float even = c0 * waves[x] + c2 * waves[16 + x] + c4 * waves[32 + x] + c6 * waves[48 + x];
      float odd = c1 * waves[8 + x] + c3 * waves[24 + x] + c5 * waves[40 + x] + c7 * waves[56 + x];
      values[from + x * step] = even + odd;
      values[from + (7 - x) * step] = even - odd;
    }
  }
}
