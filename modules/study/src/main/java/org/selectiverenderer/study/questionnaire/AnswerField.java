package org.selectiverenderer.study.questionnaire;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * An input field of a question: a choice, a line to write on, a slider, an order. Windows and paper
 * forms draw fields.
 */
public sealed interface AnswerField
    permits AnswerField.Choice, AnswerField.Line, SliderField, RankingField {
  /** Separates the values of an answer with several. */
  String SEPARATOR = "|";

  /**
   * Parses a text that was typed in, ignoring case.
   *
   * @return the value as written to tables; empty if the text is not a valid answer
   */
  Optional<String> typed(String text);

  /** Describes the valid answers to people: {@code 1 to 5}, {@code yes or no}. */
  String allowed();

  /** Returns a random valid value, for a simulated participant. */
  String simulated(Random random);

  /**
   * A choice of one or several options.
   *
   * @param options at least one, each value once
   * @param several whether more than one may be chosen
   * @param least label before the first option (the scale's lower anchor); may be empty
   * @param most label after the last option (the upper anchor); may be empty
   */
  record Choice(List<ChoiceOption> options, boolean several, String least, String most)
      implements AnswerField {
    /** Characters of labels that fit side by side. */
    private static final int ONE_LINE = 56;

    public Choice {
      options = List.copyOf(options);
    }

    /** Returns a choice of one option. */
    public static Choice of(List<ChoiceOption> options) {
      return new Choice(options, false, "", "");
    }

    /** Returns a choice of one number of a range, with labels at its ends; digits are the keys. */
    public static Choice numbers(int from, int to, String least, String most, List<String> notes) {
      List<ChoiceOption> options =
          IntStream.rangeClosed(from, to)
              .mapToObj(
                  number ->
                      new ChoiceOption(
                          Integer.toString(number),
                          Integer.toString(number),
                          notes.isEmpty() ? "" : notes.get(number - from),
                          number >= 0 && number <= 9 ? Integer.toString(number) : ""))
              .toList();
      return new Choice(options, false, least, most);
    }

    /** Returns whether the options are pictures. */
    public boolean pictured() {
      return options.stream().anyMatch(option -> option.picture().isPresent());
    }

    /** Returns whether the labels are so short that the options are laid out side by side. */
    public boolean inLine() {
      return !pictured()
          && options.stream().mapToInt(option -> option.label().length() + 2).sum() <= ONE_LINE;
    }

    /** Splits an answer into its values. */
    public static List<String> parts(String value) {
      return value.isEmpty() ? List.of() : List.of(value.split("\\|"));
    }

    /** Joins values to an answer, in the options' order. */
    public String joined(Collection<String> chosen) {
      return options.stream()
          .map(ChoiceOption::value)
          .filter(chosen::contains)
          .collect(Collectors.joining(SEPARATOR));
    }

    @Override
    public Optional<String> typed(String text) {
      List<String> found = new ArrayList<>();
      for (String part : several ? parts(text) : List.of(text)) {
        Optional<ChoiceOption> option = option(part.strip());
        if (option.isEmpty()) {
          return Optional.empty();
        }
        found.add(option.get().value());
      }
      return Optional.of(joined(found));
    }

    private Optional<ChoiceOption> option(String text) {
      return options.stream()
          .filter(each -> each.value().equalsIgnoreCase(text))
          .findFirst()
          .or(
              () ->
                  options.stream().filter(each -> each.label().equalsIgnoreCase(text)).findFirst());
    }

    @Override
    public String allowed() {
      List<String> values = options.stream().map(ChoiceOption::value).toList();
      boolean numbers = values.size() > 2 && values.stream().allMatch(v -> v.matches("-?\\d+"));
      if (numbers) {
        return values.get(0) + " to " + values.get(values.size() - 1);
      }
      if (several) {
        return "of " + String.join(SEPARATOR, values);
      }
      return String.join(" or ", values);
    }

    @Override
    public String simulated(Random random) {
      if (!several) {
        return options.get(random.nextInt(options.size())).value();
      }
      TreeSet<String> chosen = new TreeSet<>();
      chosen.add(options.get(random.nextInt(options.size())).value());
      options.stream().filter(option -> random.nextInt(4) == 0).forEach(o -> chosen.add(o.value()));
      return joined(chosen);
    }
  }

  /**
   * One or several lines to write on.
   *
   * @param lines number of lines; 1 for a number
   * @param range range of a number; empty for a text
   * @param unit label after the line; may be empty
   */
  record Line(int lines, Optional<Range> range, String unit) implements AnswerField {
    /** Maximum length of a text in characters. */
    public static final int LONGEST = 4000;

    /**
     * A range of numbers, both ends included.
     *
     * @param whole whether only whole numbers are valid
     */
    public record Range(double least, double most, boolean whole) {
      /** Returns both ends with a dash between them, for a reader of any language. */
      public String dashed() {
        return tidy(least) + " \u2013 " + tidy(most);
      }

      @Override
      public String toString() {
        return tidy(least) + " to " + tidy(most);
      }
    }

    @Override
    public Optional<String> typed(String text) {
      String stripped = text.strip();
      if (range.isEmpty()) {
        return Optional.of(stripped).filter(words -> words.length() <= LONGEST);
      }
      // German and Greek keyboards have a decimal comma.
      String number = stripped.replace(',', '.');
      if (!number.matches("[+-]?\\d{1,12}(\\.\\d{1,9})?")) {
        return Optional.empty();
      }
      double value = Double.parseDouble(number);
      Range wanted = range.get();
      boolean fits =
          value >= wanted.least
              && value <= wanted.most
              && (!wanted.whole || value == Math.rint(value));
      return fits ? Optional.of(tidy(value)) : Optional.empty();
    }

    private static String tidy(double number) {
      return number == Math.rint(number) ? Long.toString((long) number) : Double.toString(number);
    }

    @Override
    public String allowed() {
      return range.map(wanted -> wanted + (unit.isEmpty() ? "" : " " + unit)).orElse("any text");
    }

    @Override
    public String simulated(Random random) {
      if (range.isEmpty()) {
        return "simulated";
      }
      Range wanted = range.get();
      double value = wanted.least + random.nextDouble() * (wanted.most - wanted.least);
      return tidy(wanted.whole ? Math.floor(value) : Math.round(value * 10) / 10.0);
    }
  }
}
