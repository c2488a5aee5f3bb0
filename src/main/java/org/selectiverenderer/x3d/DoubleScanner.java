package org.selectiverenderer.x3d;

import ch.randelshofer.fastdoubleparser.JavaDoubleParser;
import java.util.Arrays;

/** Reads doubles, correctly rounded. They are rare in scenes, so this is the plain way. */
final class DoubleScanner {
  private double[] values = new double[16];

  double first() {
    return values[0];
  }

  double[] copy(int length) {
    return Arrays.copyOf(values, length);
  }

  /** Reads all numbers and returns how many there are. */
  int scan(char[] text, int start, int end, Flaws flaws) {
    int count = 0;
    for (int at = Words.skipSeparators(text, start, end); at < end; ) {
      int stop = Words.skipWord(text, at, end);
      if (count == values.length) {
        values = Arrays.copyOf(values, 2 * count);
      }
      double value = Double.NaN;
      if (Decimals.wellFormed(text, at, stop)) {
        value = JavaDoubleParser.parseDouble(text, at, stop - at);
      }
      if (!Double.isFinite(value)) {
        flaws.error(at - start, Decimals.complaint(text, at, stop));
        value = 0;
      }
      values[count++] = value;
      at = Words.skipSeparators(text, stop, end);
    }
    return count;
  }
}
