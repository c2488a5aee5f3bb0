package org.selectiverenderer.x3d;

import java.util.Arrays;

/** Reads whole numbers, decimal or hexadecimal ({@code 0xFF8000}). */
final class IntScanner {
  private int[] values = new int[1024];

  int first() {
    return values[0];
  }

  int[] copy(int length) {
    return Arrays.copyOf(values, length);
  }

  /** Reads all numbers and returns how many there are. */
  int scan(char[] text, int start, int end, Flaws flaws) {
    int count = 0;
    for (int at = Words.skipSeparators(text, start, end);
        at < end;
        at = Words.skipSeparators(text, at, end)) {
      if (count == values.length) {
        values = Arrays.copyOf(values, 2 * count);
      }
      at = number(text, start, at, end, count++, flaws);
    }
    return count;
  }

  /** Reads one number and returns where it ends; apart for the reason that FloatScanner gives. */
  private int number(char[] text, int start, int word, int end, int index, Flaws flaws) {
    int at = word;
    boolean negative = text[at] == '-';
    if (negative || text[at] == '+') {
      at++;
    }
    int from = at;
    int number = 0;
    int digit;
    while (at < end && (digit = text[at] - '0') >= 0 && digit <= 9) {
      number = 10 * number + digit;
      at++;
    }
    int digits = at - from;
    // Nine digits always fit.
    if (digits > 0 && digits <= 9 && (at == end || Words.separates(text[at]))) {
      values[index] = negative ? -number : number;
      return at;
    }
    at = Words.skipWord(text, word, end);
    values[index] = rare(text, start, word, at, flaws);
    return at;
  }

  private static int rare(char[] text, int start, int word, int end, Flaws flaws) {
    String shown = new String(text, word, Math.min(end - word, 100));
    if (hexadecimal(shown)) {
      return Integer.parseUnsignedInt(shown, 2, shown.length(), 16);
    }
    if (Decimals.wellFormed(text, word, end)) {
      double value = end - word <= 100 ? Double.parseDouble(shown) : Double.POSITIVE_INFINITY;
      boolean fits = value >= Integer.MIN_VALUE && value <= Integer.MAX_VALUE;
      if (!fits) {
        flaws.error(
            word - start,
            Words.quote(shown) + " does not fit into 32 bits; 0 is taken in its place");
        return 0;
      }
      // A double holds every 32-bit number exactly.
      if (value != Math.rint(value) || shown.indexOf('.') >= 0) {
        flaws.error(
            word - start, Words.quote(shown) + " is no whole number; " + (int) value + " is taken");
      }
      return (int) value;
    }
    flaws.error(word - start, Words.quote(shown) + " is no whole number; 0 is taken in its place");
    return 0;
  }

  /** Whether a word is {@code 0x} and one to eight hexadecimal digits. */
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
