package org.selectiverenderer.browser.movie.mpeg;

/** Reads bits from a byte array, the most significant bit first. Beyond the end it gives zeros. */
final class BitReader {
  private final byte[] data;
  private final long end;
  private long at;

  /**
   * @param from the index of the first byte
   * @param to the index after the last byte
   */
  BitReader(byte[] data, int from, int to) {
    this.data = data;
    at = 8L * from;
    end = 8L * Math.min(to, data.length);
  }

  /** Returns whether all bits have been read. */
  boolean over() {
    return at >= end;
  }

  /** Returns whether more bits were read than there are. */
  boolean past() {
    return at > end;
  }

  /** Returns the next bits, at most 25, without consuming them. */
  int peek(int count) {
    int from = (int) (at >> 3);
    int word = 0;
    for (int i = 0; i < 4; i++) {
      word = word << 8 | (8L * (from + i) < end ? data[from + i] & 0xff : 0);
    }
    return word << (int) (at & 7) >>> 32 - count;
  }

  /** Reads the next bits, 1 to 25. */
  int read(int count) {
    int bits = peek(count);
    at += count;
    return bits;
  }

  boolean bit() {
    return read(1) == 1;
  }

  void skip(int count) {
    at += count;
  }
}
