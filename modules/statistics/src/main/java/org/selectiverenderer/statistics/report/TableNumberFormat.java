package org.selectiverenderer.statistics.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.EffectSize;

/**
 * Formats the numbers of one table, and collects footnotes that explain values that are not
 * defined: no table ever shows NaN.
 */
final class TableNumberFormat {
  private static final String UNDEFINED = "not defined for these data";

  private final Map<String, String> marks = new LinkedHashMap<>();

  /** Returns a number with that many decimals; a dash with a footnote if it is not finite. */
  String number(double value, int decimals, Optional<String> reason) {
    if (!Double.isFinite(value)) {
      return dash(reason.orElse(UNDEFINED));
    }
    String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
    // A minus sign before zeros only is a rounding artefact.
    String plain = text.matches("-0(\\.0+)?") ? text.substring(1) : text;
    return plain.replace('-', '\u2212');
  }

  String number(double value, int decimals) {
    return number(value, decimals, Optional.empty());
  }

  /** Returns a p value, never as 0. */
  String p(double value, Optional<String> reason) {
    return Double.isFinite(value) && value < 0.001 ? "< 0.001" : number(value, 3, reason);
  }

  /** Returns a p value for a sentence: {@code = 0.012} or {@code < 0.001}. */
  String equalP(double value) {
    return value < 0.001 ? "< 0.001" : "= " + number(value, 3);
  }

  /** Returns degrees of freedom, without decimals where they are whole. */
  String df(double value) {
    return value == Math.rint(value) ? number(value, 0) : number(value, 2);
  }

  /** Returns {@code value [low, high]}. */
  String interval(double value, double low, double high, int decimals, Optional<String> reason) {
    return Double.isFinite(value) && Double.isFinite(low) && Double.isFinite(high)
        ? number(value, decimals)
            + " ["
            + number(low, decimals)
            + ", "
            + number(high, decimals)
            + "]"
        : dash(reason.orElse(UNDEFINED));
  }

  String interval(EffectSize size, Optional<String> reason) {
    return interval(size.value(), size.low(), size.high(), 3, reason);
  }

  /** Returns a Bayes factor, in scientific notation where it is very large or small. */
  String bayes(double value, Optional<String> reason) {
    if (!Double.isFinite(value)) {
      return dash(reason.orElse(UNDEFINED));
    }
    if (value == 0) {
      return "< 1e-300";
    }
    return value >= 1000 || value < 0.001
        ? String.format(Locale.ROOT, "%.1e", value)
        : number(value, value < 0.1 ? 3 : 2);
  }

  /** Returns a dash with a footnote. */
  String dash(String reason) {
    return "– (" + marks.computeIfAbsent(reason, added -> mark(marks.size())) + ")";
  }

  private static String mark(int index) {
    return index < 26 ? String.valueOf((char) ('a' + index)) : "n" + (index + 1);
  }

  /** Returns the footnotes so far. */
  List<String> notes() {
    return marks.entrySet().stream()
        .map(note -> "(" + note.getValue() + ") " + note.getKey() + ".")
        .toList();
  }
}
