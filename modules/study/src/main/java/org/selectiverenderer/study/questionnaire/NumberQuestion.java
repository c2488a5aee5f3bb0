package org.selectiverenderer.study.questionnaire;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.formats.json.JsonObjectReader;

/**
 * A question whose answer is a number in a range.
 *
 * @param unit label after the number, such as {@code mm}; may be empty
 */
record NumberQuestion(AnswerField.Line.Range range, String unit) implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "number";

  private static final double FARTHEST = 1e9;

  /** Reads {@code min}, {@code max}, {@code whole}, {@code unit}. */
  static NumberQuestion read(JsonObjectReader keys, Texts texts) {
    double least = keys.number("min", -FARTHEST, FARTHEST, 0);
    double most = keys.number("max", -FARTHEST, FARTHEST, FARTHEST);
    if (most <= least) {
      keys.fault("max", "\"max\" must be above \"min\"");
    }
    return new NumberQuestion(
        new AnswerField.Line.Range(least, most, keys.truth("whole", false)),
        texts.optional(keys, "unit"));
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public Optional<AnswerField.Line.Range> numbers() {
    return Optional.of(range);
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(new AnswerField.Line(1, Optional.of(range), unit));
  }
}
