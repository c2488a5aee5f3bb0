package org.selectiverenderer.study.questionnaire;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.formats.json.JsonObjectReader;

/** A question whose answer is a free text of one or more lines. */
record TextQuestion(int lines) implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "text";

  /** Reads {@code lines} (default 1). */
  static TextQuestion read(JsonObjectReader keys) {
    return new TextQuestion((int) keys.whole("lines", 1, 20, 1));
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(new AnswerField.Line(lines, Optional.empty(), ""));
  }
}
