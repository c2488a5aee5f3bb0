package org.selectiverenderer.study.questionnaire;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.selectiverenderer.formats.json.JsonObjectReader;

/**
 * A row of a grid: a statement, and the options that all rows of the grid have.
 *
 * @param grid id of the grid
 * @param stem text above the grid; may be empty
 */
record GridRowQuestion(String grid, String stem, List<ChoiceOption> options)
    implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "grid";

  /** Largest number of options: a row has no room for more. */
  private static final int MOST_OPTIONS = 11;

  private static final int MOST_ROWS = 100;

  GridRowQuestion {
    options = List.copyOf(options);
  }

  /**
   * Reads {@code options} and {@code rows}.
   *
   * @return the statements by the rows' ids, in order
   */
  static Map<String, String> rows(JsonObjectReader keys, Texts texts) {
    Map<String, String> rows = new LinkedHashMap<>();
    keys.objects(
        "rows",
        "a row",
        row -> {
          String id = row.text("id");
          String text = texts.text(row, "text");
          if (!id.isEmpty() && !id.matches("[0-9A-Za-z_-]+")) {
            row.fault("id", "a row's id must consist of letters, digits, hyphens and underscores");
          } else if (rows.putIfAbsent(id, text) != null) {
            row.fault("id", "the row " + id + " is defined twice");
          }
          return id;
        });
    if (rows.isEmpty() || rows.size() > MOST_ROWS) {
      keys.fault("rows", "a grid needs 1 to %d \"rows\"".formatted(MOST_ROWS));
    }
    return rows;
  }

  /** Reads the options of a grid: their texts, or numbers under their texts if those are long. */
  static List<ChoiceOption> options(JsonObjectReader keys, Texts texts) {
    List<ChoiceOption> read = SingleChoiceQuestion.options(keys, texts);
    if (read.size() > MOST_OPTIONS) {
      keys.fault(
          "options",
          "a grid may have %d options; this one has %d".formatted(MOST_OPTIONS, read.size()));
    }
    if (AnswerField.Choice.of(read).inLine()) {
      return read;
    }
    List<ChoiceOption> numbered = new ArrayList<>();
    for (ChoiceOption option : read) {
      String number = Integer.toString(numbered.size() + 1);
      numbered.add(new ChoiceOption(option.value(), number, option.label(), option.keys()));
    }
    return numbered;
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public QuestionKind naming(String old, String other) {
    return new GridRowQuestion(grid, stem.replace(old, other), options);
  }

  @Override
  public List<String> values() {
    return options.stream().map(ChoiceOption::value).toList();
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(AnswerField.Choice.of(options));
  }

  /** Returns the scale of options whose values are whole numbers in order, without gaps. */
  @Override
  public Optional<SliderField> scale() {
    if (!options.stream().allMatch(option -> option.value().matches("-?\\d{1,3}"))) {
      return Optional.empty();
    }
    List<Integer> values = values().stream().map(Integer::valueOf).toList();
    int first = values.get(0);
    boolean even =
        IntStream.range(0, values.size()).allMatch(place -> values.get(place) == first + place);
    return even
        ? Optional.of(SliderField.numbers(first, values.get(values.size() - 1), "", ""))
        : Optional.empty();
  }
}
