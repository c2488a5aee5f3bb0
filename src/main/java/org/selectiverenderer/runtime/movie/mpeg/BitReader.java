package org.selectiverenderer.runtime.movie.mpeg;

/** Reads bits, the highest of a byte first. Behind its end there are zeros. */
final class BitReader {
  private final byte[] data;
  private final long end;
  private long at;

  /**
   * @param from first byte
   * @param to behind the last one
   */
  BitReader(byte[] data, int from, int to) {
    this.data = data;
    at = 8L * from;
    end = 8L * Math.min(to, data.length);
  }

  /** Whether all bits have been read. */
  boolean over() {
    return at >= end;
  }

  /** Whether more bits were read than there are. */
  boolean past() {
    return at > end;
  }

  /** The next bits, 25 at most, which stay. */
  int peek(int count) {
    int from = (int) (at >> 3);
    int word = 0;
    for (int i = 0; i < 4; i++) {
      word = word << 8 | (8L * (from + i) < end ? data[from + i] & 0xff : 0);
    }
    return word << (int) (at & 7) >>> 32 - count;
  }

  /** The next bits, 1 to 25. */
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
