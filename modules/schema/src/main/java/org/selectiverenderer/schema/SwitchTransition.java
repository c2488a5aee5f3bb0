package org.selectiverenderer.schema;

import java.math.BigDecimal;
import java.util.Optional;

/** How the version of an object gives way to another one. */
public sealed interface SwitchTransition {
  /** The transition of the thesis (4.3). */
  SwitchTransition AT_ONCE = new AtOnce();

  /** The rate above which a turn of the head hides a change, in degrees per second. */
  double TURN = 180;

  /** The longest fade in milliseconds. */
  double LONGEST_FADE = 10_000;

  /** The fastest turn that may be asked for, in degrees per second. */
  double FASTEST_TURN = 10_000;

  /** Returns the spelling on the command line and in study files, for example {@code fade:500}. */
  String spelling();

  /** The new version is shown in the frame in which the schema is activated. */
  record AtOnce() implements SwitchTransition {
    @Override
    public String spelling() {
      return "at-once";
    }

    // Written out, as records link theirs when first called: the first frame would wait for it.
    @Override
    public String toString() {
      return spelling();
    }
  }

  /**
   * Both versions are drawn for a while, and the share of pixels that show the new one grows.
   *
   * @param milliseconds duration, above 0 and at most {@link #LONGEST_FADE}
   */
  record Fade(double milliseconds) implements SwitchTransition {
    @Override
    public String spelling() {
      return "fade:" + plain(milliseconds);
    }
  }

  /**
   * The new version is shown as soon as the viewer cannot see the object, or while the head turns
   * fast.
   *
   * @param degreesPerSecond rate of turning above which a change counts as unseen; above 0 and at
   *     most {@link #FASTEST_TURN}
   */
  record Unseen(double degreesPerSecond) implements SwitchTransition {
    @Override
    public String spelling() {
      return degreesPerSecond == TURN ? "unseen" : "unseen:" + plain(degreesPerSecond);
    }
  }

  /**
   * Returns the transition of a spelling: {@code at-once}, {@code fade:MS}, {@code unseen} or
   * {@code unseen:DEG_PER_S}; empty if it is none of these or its number is out of range.
   */
  static Optional<SwitchTransition> of(String spelling) {
    if (spelling.equals("at-once")) {
      return Optional.of(AT_ONCE);
    }
    if (spelling.equals("unseen")) {
      return Optional.of(new Unseen(TURN));
    }
    int colon = spelling.indexOf(':');
    return switch (spelling.substring(0, Math.max(0, colon))) {
      case "fade" -> number(spelling.substring(colon + 1), LONGEST_FADE).map(Fade::new);
      case "unseen" -> number(spelling.substring(colon + 1), FASTEST_TURN).map(Unseen::new);
      default -> Optional.empty();
    };
  }

  private static Optional<Double> number(String text, double largest) {
    if (!text.matches("[0-9]{1,9}(\\.[0-9]{1,9})?")) {
      return Optional.empty();
    }
    return Optional.of(Double.valueOf(text)).filter(value -> value > 0 && value <= largest);
  }

  private static String plain(double number) {
    return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
  }
}
