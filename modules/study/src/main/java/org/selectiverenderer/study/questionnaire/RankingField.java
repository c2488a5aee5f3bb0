package org.selectiverenderer.study.questionnaire;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * Options that are put in order. The value is all options' values from the first to the last,
 * joined by {@link AnswerField#SEPARATOR}.
 *
 * @param options in the order in which they are shown first, which is no answer
 */
public record RankingField(List<ChoiceOption> options) implements AnswerField {
  public RankingField {
    options = List.copyOf(options);
  }

  /** Returns the options in the order of an answer; in the first order for no answer. */
  public List<ChoiceOption> ordered(String value) {
    List<String> parts = Choice.parts(value);
    return parts.isEmpty()
        ? options
        : parts.stream()
            .flatMap(part -> options.stream().filter(option -> option.value().equals(part)))
            .toList();
  }

  /** Returns the value of an order. */
  public static String value(List<ChoiceOption> order) {
    return order.stream().map(ChoiceOption::value).collect(Collectors.joining(SEPARATOR));
  }

  @Override
  public Optional<String> typed(String text) {
    List<String> parts = Choice.parts(text).stream().map(String::strip).toList();
    List<ChoiceOption> order =
        parts.stream()
            .flatMap(
                part ->
                    options.stream()
                        .filter(option -> option.value().equalsIgnoreCase(part))
                        .limit(1))
            .toList();
    boolean all =
        parts.size() == options.size()
            && order.size() == options.size()
            && new HashSet<>(order).size() == options.size();
    return all ? Optional.of(value(order)) : Optional.empty();
  }

  @Override
  public String allowed() {
    return "all of "
        + options.stream().map(ChoiceOption::value).sorted().collect(Collectors.joining(SEPARATOR))
        + ", from the first to the last";
  }

  @Override
  public String simulated(Random random) {
    List<ChoiceOption> order = new ArrayList<>(options);
    Collections.shuffle(order, random);
    return value(order);
  }
}
