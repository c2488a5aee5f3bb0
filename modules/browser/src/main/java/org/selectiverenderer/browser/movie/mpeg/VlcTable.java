package org.selectiverenderer.browser.movie.mpeg;

import java.util.Arrays;
import java.util.Map;

/** A decoding table for a variable-length code, indexed by the next bits. */
final class VlcTable {
  /** The value that {@link #read} returns for bits that are no code word. */
  static final int NONE = -1;

  private final int longest;
  private final short[] values;
  private final byte[] lengths;

  /**
   * @param codes the code words, as strings of 0 and 1, with their values
   */
  VlcTable(Map<String, Integer> codes) {
    longest = codes.keySet().stream().mapToInt(String::length).max().orElseThrow();
    values = new short[1 << longest];
    lengths = new byte[1 << longest];
    Arrays.fill(values, (short) NONE);
    codes.forEach(
        (code, value) -> {
          int free = longest - code.length();
          int first = Integer.parseInt(code, 2) << free;
          Arrays.fill(values, first, first + (1 << free), value.shortValue());
          Arrays.fill(lengths, first, first + (1 << free), (byte) code.length());
        });
  }

  /** Reads a code word and returns its value. */
  int read(BitReader bits) {
    int next = bits.peek(longest);
    bits.skip(lengths[next]);
    return values[next];
  }
}
