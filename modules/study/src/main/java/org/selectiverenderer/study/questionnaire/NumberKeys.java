package org.selectiverenderer.study.questionnaire;

import java.util.List;
import java.util.Optional;

/**
 * The keys that have been typed of a number of a scale or slider. A digit is not an answer yet
 * while another may follow it: on a scale from 0 to 10 a 1 may become 10. A key that cannot follow
 * begins anew, so that it corrects the answer.
 *
 * @param values the numbers of the scale
 * @param typed the keys so far; empty before the first one, else the beginning of a number
 */
public record NumberKeys(List<String> values, String typed) {
  public NumberKeys {
    values = List.copyOf(values);
  }

  /**
   * Returns the keys of a choice, before the first one.
   *
   * @return empty for a choice whose options are not typed as numbers
   */
  public static Optional<NumberKeys> of(AnswerField.Choice choice) {
    boolean numbers =
        !choice.several() && choice.options().stream().allMatch(NumberKeys::typedAsItself);
    return numbers
        ? Optional.of(
            new NumberKeys(choice.options().stream().map(ChoiceOption::value).toList(), ""))
        : Optional.empty();
  }

  /**
   * Returns the keys of a slider whose value is shown, before the first one.
   *
   * @return empty for a slider whose value cannot be typed
   */
  public static Optional<NumberKeys> of(SliderField slider) {
    return slider.number() ? Optional.of(new NumberKeys(slider.values(), "")) : Optional.empty();
  }

  /** Returns the keys of a field, before the first one; empty for one that takes no numbers. */
  public static Optional<NumberKeys> of(AnswerField field) {
    if (field instanceof AnswerField.Choice choice) {
      return of(choice);
    }
    return field instanceof SliderField slider ? of(slider) : Optional.empty();
  }

  private static boolean typedAsItself(ChoiceOption option) {
    return option.value().matches("-?\\d+")
        && option.label().equals(option.value())
        && option.keys().equals(option.value().length() == 1 ? option.value() : "");
  }

  /** Returns the keys with another one; the same if no number has it at this place or as first. */
  public NumberKeys and(char key) {
    String longer = typed + key;
    String anew = String.valueOf(key);
    if (begins(longer)) {
      return new NumberKeys(values, longer);
    }
    return begins(anew) ? new NumberKeys(values, anew) : this;
  }

  private boolean begins(String keys) {
    return values.stream().anyMatch(value -> value.startsWith(keys));
  }

  /** Returns the keys before the first one. */
  public NumberKeys none() {
    return new NumberKeys(values, "");
  }

  /** Returns whether a key can begin a number of the scale, or continue the one that is typed. */
  public boolean takes(char key) {
    return begins(typed + key) || begins(String.valueOf(key));
  }

  /** Returns whether keys were typed that another one can follow. */
  public boolean waits() {
    return !typed.isEmpty()
        && values.stream()
            .anyMatch(value -> value.startsWith(typed) && value.length() > typed.length());
  }

  /** Returns whether a number of the scale is the beginning of another. */
  public boolean mayWait() {
    return values.stream().anyMatch(value -> new NumberKeys(values, value).waits());
  }

  /** Returns the number that is typed; empty if it is not one of the scale. */
  public Optional<String> value() {
    return Optional.of(typed).filter(values::contains);
  }
}
