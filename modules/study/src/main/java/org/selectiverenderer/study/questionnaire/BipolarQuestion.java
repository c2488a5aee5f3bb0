package org.selectiverenderer.study.questionnaire;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.selectiverenderer.formats.json.JsonObjectReader;

/**
 * A bipolar scale (semantic differential): a rating between two opposites, such as dark and bright,
 * from 1 to an odd or even number.
 */
record BipolarQuestion(int to, String left, String right) implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "bipolar";

  /** Reads {@code left}, {@code right} and {@code to} (default 7). */
  static BipolarQuestion read(JsonObjectReader keys, Texts texts) {
    return new BipolarQuestion(
        (int) keys.whole("to", 2, 11, 7), texts.text(keys, "left"), texts.text(keys, "right"));
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<String> values() {
    return IntStream.rangeClosed(1, to).mapToObj(Integer::toString).toList();
  }

  @Override
  public Optional<SliderField> scale() {
    return Optional.of(SliderField.numbers(1, to, left, right));
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(AnswerField.Choice.numbers(1, to, left, right, List.of()));
  }
}
