package org.selectiverenderer.experiment.questionnaire;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.json.JsonMembers;

/** Words of the participant's own, on one line or more. */
record TextQuestion(int lines) implements QuestionKind {
  /** As files spell it. */
  static final String SPELLING = "text";

  /** Reads {@code lines}, which are 1 if left out. */
  static TextQuestion read(JsonMembers keys) {
    return new TextQuestion((int) keys.whole("lines", 1, 20, 1));
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<AnswerField> fields(Wording wording) {
    return List.of(new AnswerField.Line(lines, Optional.empty(), ""));
  }
}
