package org.selectiverenderer.x3d.field;

import java.util.Locale;

/** Parses decimal numbers, for the scanners of floats and doubles. */
final class DecimalParser {
  private static final double[] TENS = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22
  };

  private DecimalParser() {}

  /**
   * Returns the value of a well-formed number with known digits, correctly rounded, or NaN if this
   * fast path does not apply (Clinger 1990).
   *
   * @param number the digits before the exponent as an integer, at most 2<sup>53</sup>
   * @param scale the number of digits after the decimal point
   */
  static double exact(char[] text, int word, int end, long number, int scale) {
    int at = word;
    while (at < end && text[at] != 'e' && text[at] != 'E') {
      at++;
    }
    int power = -scale;
    if (at < end) {
      boolean negative = text[++at] == '-';
      if (negative || text[at] == '+') {
        at++;
      }
      if (end - at > 3) {
        return Double.NaN;
      }
      int exponent = 0;
      for (; at < end; at++) {
        exponent = 10 * exponent + text[at] - '0';
      }
      power += negative ? -exponent : exponent;
    }
    if (power < -22 || power > 22) {
      return Double.NaN;
    }
    double value = power < 0 ? number / TENS[-power] : number * TENS[power];
    return text[word] == '-' ? -value : value;
  }

  /** Returns whether a word has the form of an X3D number: sign, digits, point, exponent. */
  static boolean wellFormed(char[] text, int word, int end) {
    int at = word;
    if (at < end && (text[at] == '-' || text[at] == '+')) {
      at++;
    }
    int digits = 0;
    boolean point = false;
    for (; at < end && (digit(text[at]) || text[at] == '.' && !point); at++) {
      if (text[at] == '.') {
        point = true;
      } else {
        digits++;
      }
    }
    if (digits == 0) {
      return false;
    }
    if (at == end) {
      return true;
    }
    if (text[at] != 'e' && text[at] != 'E') {
      return false;
    }
    at++;
    if (at < end && (text[at] == '-' || text[at] == '+')) {
      at++;
    }
    int exponent = at;
    while (at < end && digit(text[at])) {
      at++;
    }
    return at == end && at > exponent;
  }

  private static boolean digit(char c) {
    return c >= '0' && c <= '9';
  }

  /** Returns the message for a word that is not a number, not finite, or too large for its type. */
  static String complaint(char[] text, int word, int end) {
    String quoted = FieldTokenizer.quote(new String(text, word, Math.min(end - word, 100)));
    if (wellFormed(text, word, end)) {
      return quoted + " is too large for the field's type; 0 is used instead";
    }
    String lower = quoted.toLowerCase(Locale.ROOT);
    return lower.contains("nan") || lower.contains("inf")
        ? quoted + " is not a finite number; 0 is used instead"
        : quoted + " is not a number; 0 is used instead";
  }
}
