package org.selectiverenderer.control.budget;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A budget limits what a frame may cost.
 *
 * @param amount triangles of the whole scene, or milliseconds of a frame; above 0
 */
public record RenderingBudget(Unit unit, double amount) {
  /** What is limited. */
  public enum Unit {
    /** The triangles of the whole scene with its current versions, in view or not. */
    TRIANGLES,
    /** The milliseconds that stepping and drawing a frame takes. */
    MS
  }

  private static final Pattern TRIANGLES = Pattern.compile("triangles:([0-9]{1,12})");
  private static final Pattern MS = Pattern.compile("ms:([0-9]{1,4}(?:\\.[0-9]{1,6})?)");

  /** Checks the amount. */
  public RenderingBudget {
    if (!(amount > 0 && amount < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("a budget is above 0, not " + amount);
    }
  }

  /** Parses {@code triangles:N} or {@code ms:T}; empty for anything else. */
  public static Optional<RenderingBudget> of(String text) {
    Matcher triangles = TRIANGLES.matcher(text);
    if (triangles.matches()) {
      return above(Unit.TRIANGLES, triangles.group(1));
    }
    Matcher ms = MS.matcher(text);
    return ms.matches() ? above(Unit.MS, ms.group(1)) : Optional.empty();
  }

  private static Optional<RenderingBudget> above(Unit unit, String amount) {
    double number = Double.parseDouble(amount);
    return number > 0 ? Optional.of(new RenderingBudget(unit, number)) : Optional.empty();
  }

  /** Returns the text that {@link #of} parses. */
  @Override
  public String toString() {
    String number = amount == Math.rint(amount) ? Long.toString((long) amount) : "" + amount;
    return unit.name().toLowerCase(Locale.ROOT) + ":" + number;
  }
}
