package org.selectiverenderer.enricher.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/**
 * The goals of an object's versions as the author types them: one number per version.
 *
 * @param targets the goals; empty if the text is none
 * @param fault what is wrong with the text; empty if nothing is
 */
record BatchGoal(List<SimplificationTarget> targets, String fault) {
  /** What the numbers mean. */
  enum Kind {
    /** Shares of the vertices to keep, in percent. */
    PERCENT("versions.percent", "50"),
    /** Largest deviations from the original, in percent of its size. */
    TOLERANCE("manyversions.tolerance", "1");

    private final String text;
    private final String usual;

    Kind(String text, String usual) {
      this.text = text;
      this.usual = usual;
    }

    /** Returns the goals to begin with. */
    String usual() {
      return usual;
    }

    @Override
    public String toString() {
      return Texts.of(text);
    }
  }

  private static final Pattern SEPARATORS = Pattern.compile("[;\\s]+|,(?=\\s|$)[;,\\s]*");

  /** A comma between digits: a decimal number to some, two numbers to others. */
  private static final Pattern EITHER = Pattern.compile("(\\d+),(\\d+)");

  /** Three numbers or more with commas between can only be a list. */
  private static final Pattern LIST = Pattern.compile("[\\d.]+(,[\\d.]+){2,}");

  private static final Pattern DECIMAL = Pattern.compile("\\d{1,9}(\\.\\d{1,9})?|\\.\\d{1,9}");

  /** Copies the list. */
  BatchGoal {
    targets = List.copyOf(targets);
  }

  /** Reads numbers above 0 and at most 100; semicolons, spaces, or commas separate. */
  static BatchGoal read(Kind kind, String text) {
    List<SimplificationTarget> goals = new ArrayList<>();
    for (String number : numbers(text)) {
      if (EITHER.matcher(number).matches()) {
        return wrong(
            Texts.of(
                "manyversions.either",
                number,
                number.replace(',', '.'),
                number.replace(",", ", ")));
      }
      double value = DECIMAL.matcher(number).matches() ? Double.parseDouble(number) : Double.NaN;
      if (!(value > 0 && value <= 100)) {
        return wrong(
            number.isEmpty()
                ? Texts.of("manyversions.goal.tip")
                : Texts.of("manyversions.nonumber", number));
      }
      goals.add(
          kind == Kind.PERCENT
              ? new SimplificationTarget.VertexPercent(value)
              : new SimplificationTarget.LargestError(value / 100));
    }
    return goals.size() > VersionsModel.MOST
        ? wrong(Texts.of("manyversions.toomany", String.valueOf(VersionsModel.MOST)))
        : new BatchGoal(goals, "");
  }

  private static List<String> numbers(String text) {
    return Stream.of(SEPARATORS.split(text.strip()))
        .flatMap(
            part -> LIST.matcher(part).matches() ? Stream.of(part.split(",")) : Stream.of(part))
        .toList();
  }

  private static BatchGoal wrong(String sentence) {
    return new BatchGoal(List.of(), sentence);
  }

  /** Returns whether the text was goals. */
  boolean valid() {
    return fault.isEmpty();
  }
}
