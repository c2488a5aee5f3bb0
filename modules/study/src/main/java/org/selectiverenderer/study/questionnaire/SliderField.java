package org.selectiverenderer.study.questionnaire;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * A slider: positions on a line between two ends. Positions are counted from 0 at the left end; a
 * position has the value {@code from + position * step}, which is exact, without errors of binary
 * fractions.
 *
 * @param from value of the left end
 * @param to value of the right end, a whole number of steps above {@code from}
 * @param step difference of neighbouring values, above 0
 * @param least label of the left end; may be empty
 * @param most label of the right end; may be empty
 * @param marks whether the line has marks
 * @param number whether the value is shown and may be typed
 * @param start position of the thumb before it is touched, which is no answer; empty for no thumb
 */
public record SliderField(
    BigDecimal from,
    BigDecimal to,
    BigDecimal step,
    String least,
    String most,
    boolean marks,
    boolean number,
    OptionalInt start)
    implements AnswerField {
  /** Largest number of steps between the ends. */
  public static final int MOST_STEPS = 10_000;

  /** Largest number of distances between marks. */
  private static final int MOST_MARKS = 20;

  /** Largest number of distances between marks with a number. */
  private static final int MOST_LABELS = 10;

  /** Returns a slider over whole numbers with marks, on which a number may be typed. */
  static SliderField numbers(int from, int to, String least, String most) {
    return new SliderField(
        BigDecimal.valueOf(from),
        BigDecimal.valueOf(to),
        BigDecimal.ONE,
        least,
        most,
        true,
        true,
        OptionalInt.empty());
  }

  /** Returns the last position, that of the right end. */
  public int last() {
    return to.subtract(from).divideToIntegralValue(step).intValueExact();
  }

  /** Returns the value of a position as written to tables. */
  public String value(int position) {
    return tidy(from.add(step.multiply(BigDecimal.valueOf(position))));
  }

  /** Returns the values of all positions. */
  public List<String> values() {
    return IntStream.rangeClosed(0, last()).mapToObj(this::value).toList();
  }

  private static String tidy(BigDecimal number) {
    return number.signum() == 0 ? "0" : number.stripTrailingZeros().toPlainString();
  }

  /** Returns the position of a value; empty if none has this value. */
  public OptionalInt position(String value) {
    if (!value.matches("[+-]?\\d{1,12}(\\.\\d{1,9})?")) {
      return OptionalInt.empty();
    }
    BigDecimal[] steps = new BigDecimal(value).subtract(from).divideAndRemainder(step);
    boolean fits =
        steps[1].signum() == 0
            && steps[0].signum() >= 0
            && steps[0].compareTo(BigDecimal.valueOf(last())) <= 0;
    return fits ? OptionalInt.of(steps[0].intValueExact()) : OptionalInt.empty();
  }

  /** Returns the value of a position that is nearest to a number. */
  public String nearest(double number) {
    double limited = Math.max(from.doubleValue(), Math.min(to.doubleValue(), number));
    int position =
        BigDecimal.valueOf(limited)
            .subtract(from)
            .divide(step, 0, RoundingMode.HALF_UP)
            .intValueExact();
    return value(Math.min(last(), position));
  }

  /** Returns the position after a move; of a thumb that is not there yet, the middle. */
  public int moved(OptionalInt position, int by) {
    if (position.isEmpty()) {
      return (last() + 1) / 2;
    }
    return Math.max(0, Math.min(last(), position.getAsInt() + by));
  }

  /** Returns how many positions a page key moves: about a tenth of the line. */
  public int page() {
    return Math.max(1, (last() + 5) / 10);
  }

  /** Returns the positions that have a mark, both ends included; none for a line without marks. */
  public List<Integer> marked() {
    return marks ? every(MOST_MARKS) : List.of();
  }

  /** Returns the positions whose marks have a number; none where the value is not shown. */
  public List<Integer> labelled() {
    return marks && number ? every(MOST_LABELS) : List.of();
  }

  private List<Integer> every(int most) {
    int last = last();
    int apart =
        IntStream.rangeClosed(1, last)
            .filter(each -> last % each == 0 && last / each <= most)
            .findFirst()
            .orElse(last);
    return IntStream.rangeClosed(0, last / apart).mapToObj(each -> each * apart).toList();
  }

  @Override
  public Optional<String> typed(String text) {
    // German and Greek keyboards have a decimal comma.
    OptionalInt position = position(text.strip().replace(',', '.'));
    return position.isPresent() ? Optional.of(value(position.getAsInt())) : Optional.empty();
  }

  @Override
  public String allowed() {
    String ends = tidy(from) + " to " + tidy(to);
    return step.compareTo(BigDecimal.ONE) == 0 ? ends : ends + " in steps of " + tidy(step);
  }

  @Override
  public String simulated(Random random) {
    return value(random.nextInt(last() + 1));
  }
}
