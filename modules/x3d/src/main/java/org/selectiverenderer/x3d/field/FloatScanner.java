package org.selectiverenderer.x3d.field;

import ch.randelshofer.fastdoubleparser.JavaFloatParser;
import java.util.Arrays;

/**
 * Reads floats, correctly rounded. Most of a scene's text is coordinates, and their usual form, up
 * to 18 digits and a small exponent, is parsed by a fast path (Clinger 1990).
 *
 * <p>Integers up to 2<sup>24</sup> and powers of ten up to 10<sup>10</sup> are exact floats, so
 * that their quotient is rounded only once, hence correctly. The same holds for doubles up to
 * 2<sup>53</sup> and 10<sup>22</sup>; rounding such a double to a float is correct unless it lies
 * exactly midway between two floats. All other numbers are parsed by FastDoubleParser.
 */
final class FloatScanner extends NumberScanner {
  private static final int FLOAT_DIGITS = 1 << 24;
  private static final long DOUBLE_DIGITS = 1L << 53;
  private static final long BELOW_FLOAT = (1L << 29) - 1;
  private static final long MIDDLE = 1L << 28;

  private static final float[] FLOAT_TENS = {
    1e0f, 1e1f, 1e2f, 1e3f, 1e4f, 1e5f, 1e6f, 1e7f, 1e8f, 1e9f, 1e10f
  };

  private float[] values;

  FloatScanner() {
    super(1024);
    values = new float[1024];
  }

  float first() {
    return values[0];
  }

  float[] copy(int length) {
    return Arrays.copyOf(values, length);
  }

  @Override
  void grow(int wanted) {
    values = Arrays.copyOf(values, wanted);
  }

  @Override
  int plain(char[] text, int at, int end, int index, int stop) {
    float[] into = values;
    float[] tens = FLOAT_TENS;
    int count = index;
    int read = at;
    int i = at;
    while (count < stop) {
      char c = 0;
      while (i < end && ((c = text[i]) <= ' ' || c == ',')) {
        i++;
      }
      if (i == end) {
        break;
      }
      boolean negative = c == '-';
      if (negative || c == '+') {
        i++;
      }
      int number = 0;
      int from = i;
      int digit;
      while (i < end && (digit = text[i] - '0' & 0xffff) <= 9) {
        number = 10 * number + digit;
        i++;
      }
      int digits = i - from;
      int scale = 0;
      if (i < end && text[i] == '.') {
        from = ++i;
        while (i < end && (digit = text[i] - '0' & 0xffff) <= 9) {
          number = 10 * number + digit;
          i++;
        }
        scale = i - from;
        digits += scale;
      }
      // nine digits never overflow
      if (digits == 0
          || digits > 9
          || number > FLOAT_DIGITS
          || i < end && !FieldTokenizer.separates(text[i])) {
        break;
      }
      float value = number / tens[scale];
      into[count++] = negative ? -value : value;
      read = i;
    }
    next = count;
    return read;
  }

  @Override
  int number(char[] text, int start, int word, int end, int index, FieldParseErrors flaws) {
    int from = FieldTokenizer.skipSign(text, word);
    int at = from;
    long number = 0;
    int digit;
    while (at < end && (digit = text[at] - '0') >= 0 && digit <= 9) {
      number = 10 * number + digit;
      at++;
    }
    int digits = at - from;
    int scale = 0;
    if (at < end && text[at] == '.') {
      at++;
      int point = at;
      while (at < end && (digit = text[at] - '0') >= 0 && digit <= 9) {
        number = 10 * number + digit;
        at++;
      }
      scale = at - point;
      digits += scale;
    }
    if ((at == end || FieldTokenizer.separates(text[at]))
        && number <= FLOAT_DIGITS
        && scale <= 10
        && digits <= 18
        && digits > 0) {
      float value = number / FLOAT_TENS[scale];
      values[index] = text[word] == '-' ? -value : value;
      return at;
    }
    at = FieldTokenizer.skipWord(text, word, end);
    values[index] = rare(text, start, word, at, number, digits, scale, flaws);
    return at;
  }

  /** Parses a number that is long, has an exponent or is invalid. */
  private static float rare(
      char[] text,
      int start,
      int word,
      int end,
      long number,
      int digits,
      int scale,
      FieldParseErrors flaws) {
    boolean wellFormed = DecimalParser.wellFormed(text, word, end);
    if (wellFormed && digits <= 18 && number > 0 && number <= DOUBLE_DIGITS) {
      double value = DecimalParser.exact(text, word, end, number, scale);
      long bits = Double.doubleToRawLongBits(value);
      if (Math.abs(value) >= Float.MIN_NORMAL
          && Math.abs(value) < 1e38
          && (bits & BELOW_FLOAT) != MIDDLE) {
        return (float) value;
      }
    }
    if (wellFormed) {
      float value = JavaFloatParser.parseFloat(text, word, end - word);
      if (Float.isFinite(value)) {
        return value;
      }
    }
    flaws.error(word - start, DecimalParser.complaint(text, word, end));
    return 0;
  }
}
