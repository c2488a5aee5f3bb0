package org.selectiverenderer.study.questionnaire;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.formats.json.JsonObjectReader;

/** A single choice: one of several options. */
record SingleChoiceQuestion(List<ChoiceOption> options) implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "single";

  /** Pattern of values, which are valid in tables and as keys of other programs. */
  private static final String VALUE = "[0-9A-Za-z_.+-]+";

  /** Largest number of pictures of a question, for whose pixels there must be memory. */
  private static final int MOST_PICTURES = 24;

  SingleChoiceQuestion {
    options = List.copyOf(options);
  }

  /** Reads {@code options}. */
  static SingleChoiceQuestion read(JsonObjectReader keys, Texts texts) {
    return new SingleChoiceQuestion(pictured(keys, texts));
  }

  /**
   * Reads options, each with a value and a text; the digits 1 to 9 are the keys of the first nine.
   */
  static List<ChoiceOption> options(JsonObjectReader keys, Texts texts) {
    return options(keys, texts, false);
  }

  /** Reads options that may be pictures: all of them, or none. */
  static List<ChoiceOption> pictured(JsonObjectReader keys, Texts texts) {
    List<ChoiceOption> options = options(keys, texts, true);
    long pictures = options.stream().filter(option -> option.picture().isPresent()).count();
    if (pictures > 0 && pictures < options.size()) {
      keys.fault("options", "either all options have a \"picture\" or none has");
    } else if (pictures > MOST_PICTURES) {
      keys.fault(
          "options",
          "a question may have %d pictures; this one has %d".formatted(MOST_PICTURES, pictures));
    }
    return options;
  }

  private static List<ChoiceOption> options(JsonObjectReader keys, Texts texts, boolean pictures) {
    Set<String> values = new HashSet<>();
    List<ChoiceOption> options = new ArrayList<>();
    keys.objects(
        "options",
        "an option",
        option -> {
          String value = option.text("value");
          String label = texts.text(option, "text");
          if (!value.isEmpty() && !value.matches(VALUE)) {
            option.fault(
                "value", "the value of an option consists of letters, digits and the signs _.+-");
          } else if (!values.add(value)) {
            option.fault("value", "the value " + value + " occurs twice");
          }
          int number = options.size() + 1;
          return options.add(
              new ChoiceOption(
                  value,
                  label,
                  "",
                  number <= 9 ? Integer.toString(number) : "",
                  pictures ? texts.picture(option, "picture") : Optional.empty()));
        });
    if (options.size() < 2) {
      keys.fault("options", "a choice needs at least two \"options\"");
    }
    return options;
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<String> values() {
    return options.stream().map(ChoiceOption::value).toList();
  }

  @Override
  public List<Path> pictures() {
    return options.stream().flatMap(option -> option.picture().stream()).toList();
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(AnswerField.Choice.of(options));
  }
}
