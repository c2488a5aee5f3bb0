package org.selectiverenderer.statistics.apa;

import java.util.Locale;

/**
 * Formats numbers as the APA Publication Manual does (7th edition, 6.36): no zero before the point
 * of what cannot exceed 1, such as p and proportions; a minus sign, not a hyphen.
 */
final class ApaNumberFormat {
  /** Stands for a value that is not defined. */
  public static final String NONE = "–";

  private ApaNumberFormat() {}

  /** Returns the number with that many decimals. */
  public static String of(double value, int decimals) {
    if (!Double.isFinite(value)) {
      return NONE;
    }
    String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
    return (text.matches("-0(\\.0+)?") ? text.substring(1) : text).replace('-', '\u2212');
  }

  /** Returns a quantity from -1 to 1, without a zero before the point. */
  public static String share(double value, int decimals) {
    return of(value, decimals).replaceFirst("^(\u2212?)0\\.", "$1.");
  }

  /** Returns p, such as {@code .109}; below a thousandth {@code < .001}. */
  public static String p(double p) {
    return p < 0.001 ? "< .001" : p > 0.999 && p <= 1 ? "> .999" : share(p, 3);
  }

  /** Returns the symbol with p, such as {@code p = .109} or {@code p < .001}. */
  static String withP(String symbol, double p) {
    String text = p(p);
    return text.startsWith("<") || text.startsWith(">")
        ? symbol + " " + text
        : symbol + " = " + text;
  }

  /** Returns degrees of freedom, without decimals where they are whole. */
  public static String df(double df) {
    return of(df, df == Math.rint(df) ? 0 : 2);
  }

  /** Returns an interval, such as {@code [.00, .19]}. */
  static String interval(double low, double high, int decimals) {
    return "[" + share(low, decimals) + ", " + share(high, decimals) + "]";
  }

  /** Returns a Bayes factor, in scientific notation where it is very large or small. */
  public static String bayes(double value) {
    if (!Double.isFinite(value)) {
      return NONE;
    }
    return value >= 10_000 || value < 0.001
        ? String.format(Locale.ROOT, "%.1e", value).replace('-', '\u2212')
        : of(value, value < 0.1 ? 3 : 2);
  }
}
