package org.selectiverenderer.x3d.field;

import ch.randelshofer.fastdoubleparser.JavaDoubleParser;
import java.util.Arrays;

/** Reads doubles, correctly rounded; not optimized, since they are rare in scenes. */
final class DoubleScanner extends NumberScanner {
  private double[] values;

  DoubleScanner() {
    super(16);
    values = new double[16];
  }

  double first() {
    return values[0];
  }

  double[] copy(int length) {
    return Arrays.copyOf(values, length);
  }

  @Override
  void grow(int wanted) {
    values = Arrays.copyOf(values, wanted);
  }

  @Override
  int number(char[] text, int start, int word, int end, int index, Flaws flaws) {
    int stop = Tokens.skipWord(text, word, end);
    double value = Double.NaN;
    if (DecimalScan.wellFormed(text, word, stop)) {
      value = JavaDoubleParser.parseDouble(text, word, stop - word);
    }
    if (!Double.isFinite(value)) {
      flaws.error(word - start, DecimalScan.complaint(text, word, stop));
      value = 0;
    }
    values[index] = value;
    return stop;
  }
}
