package org.selectiverenderer.x3d.field;

import java.util.Arrays;

/** Reads 32-bit integers, decimal or hexadecimal ({@code 0xFF8000}). */
final class IntScanner extends NumberScanner {
  private int[] values;

  IntScanner() {
    super(1024);
    values = new int[1024];
  }

  int first() {
    return values[0];
  }

  int[] copy(int length) {
    return Arrays.copyOf(values, length);
  }

  @Override
  void grow(int wanted) {
    values = Arrays.copyOf(values, wanted);
  }

  @Override
  int plain(char[] text, int at, int end, int index, int stop) {
    int[] into = values;
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
      // nine digits never overflow
      if (i == from || i - from > 9 || i < end && !FieldTokenizer.separates(text[i])) {
        break;
      }
      into[count++] = negative ? -number : number;
      read = i;
    }
    next = count;
    return read;
  }

  @Override
  int number(char[] text, int start, int word, int end, int index, FieldParseErrors flaws) {
    int from = FieldTokenizer.skipSign(text, word);
    int at = from;
    int number = 0;
    int digit;
    while (at < end && (digit = text[at] - '0') >= 0 && digit <= 9) {
      number = 10 * number + digit;
      at++;
    }
    int digits = at - from;
    // nine digits never overflow
    if (digits > 0 && digits <= 9 && (at == end || FieldTokenizer.separates(text[at]))) {
      values[index] = text[word] == '-' ? -number : number;
      return at;
    }
    at = FieldTokenizer.skipWord(text, word, end);
    values[index] = rare(text, start, word, at, flaws);
    return at;
  }

  private static int rare(char[] text, int start, int word, int end, FieldParseErrors flaws) {
    String shown = new String(text, word, Math.min(end - word, 100));
    if (hexadecimal(shown)) {
      return Integer.parseUnsignedInt(shown, 2, shown.length(), 16);
    }
    if (DecimalParser.wellFormed(text, word, end)) {
      double value = end - word <= 100 ? Double.parseDouble(shown) : Double.POSITIVE_INFINITY;
      boolean fits = value >= Integer.MIN_VALUE && value <= Integer.MAX_VALUE;
      if (!fits) {
        flaws.error(
            word - start,
            FieldTokenizer.quote(shown) + " does not fit into 32 bits; 0 is used instead");
        return 0;
      }
      // every 32-bit integer is an exact double
      if (value != Math.rint(value) || shown.indexOf('.') >= 0) {
        flaws.error(
            word - start,
            FieldTokenizer.quote(shown) + " is not a whole number; " + (int) value + " is used");
      }
      return (int) value;
    }
    flaws.error(
        word - start, FieldTokenizer.quote(shown) + " is not a whole number; 0 is used instead");
    return 0;
  }

  /** Returns whether a word is {@code 0x} and one to eight hexadecimal digits. */
  private static boolean hexadecimal(String word) {
    if (word.length() < 3 || word.length() > 10 || !word.regionMatches(true, 0, "0x", 0, 2)) {
      return false;
    }
    for (int i = 2; i < word.length(); i++) {
      char c = word.charAt(i);
      if (c > 'f' || Character.digit(c, 16) < 0) {
        return false;
      }
    }
    return true;
  }
}
