package org.selectiverenderer.study.questionnaire;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.selectiverenderer.formats.json.JsonObjectReader;

/**
 * A rating scale (Likert) between two labelled ends.
 *
 * @param notes the meaning of each step; empty if only the ends are labelled
 */
record ScaleQuestion(int from, int to, String least, String most, List<String> notes)
    implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "scale";

  /** Maximum number of steps that are buttons: a row has no room for more. */
  private static final int MOST_BUTTONS = 11;

  private static final int MOST_STEPS = 101;

  public ScaleQuestion {
    notes = List.copyOf(notes);
  }

  /** Reads {@code from}, {@code to}, {@code least}, {@code most}, {@code steps}. */
  static ScaleQuestion read(JsonObjectReader keys, Texts texts) {
    int from = (int) keys.whole("from", -100, 100, 1);
    int to = (int) keys.whole("to", -100, 200, 5);
    if (to <= from || to - from >= MOST_STEPS) {
      keys.fault(
          "to",
          "a scale must have 2 to %d steps; this one goes from %d to %d"
              .formatted(MOST_STEPS, from, to));
      to = from + 1;
    }
    List<String> notes = texts.list(keys, "steps");
    if (!notes.isEmpty() && notes.size() != to - from + 1) {
      keys.fault(
          "steps",
          "there are %d names for the %d steps of the scale"
              .formatted(notes.size(), to - from + 1));
      notes = List.of();
    }
    if (!notes.isEmpty() && notes.size() > MOST_BUTTONS) {
      keys.fault(
          "steps",
          "the steps of a scale have names where it has at most %d".formatted(MOST_BUTTONS));
    }
    return new ScaleQuestion(
        from, to, texts.optional(keys, "least"), texts.optional(keys, "most"), notes);
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<String> values() {
    return IntStream.rangeClosed(from, to).mapToObj(Integer::toString).toList();
  }

  @Override
  public Optional<SliderField> scale() {
    return Optional.of(SliderField.numbers(from, to, least, most));
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(
        to - from < MOST_BUTTONS
            ? AnswerField.Choice.numbers(from, to, least, most, notes)
            : SliderField.numbers(from, to, least, most));
  }
}
