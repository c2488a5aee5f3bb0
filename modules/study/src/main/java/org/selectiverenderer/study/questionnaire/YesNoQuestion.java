package org.selectiverenderer.study.questionnaire;

import java.util.List;

/** A question whose answer is yes or no. */
record YesNoQuestion() implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "yes-no";

  /** Returns the choice between yes and no. */
  static AnswerField field(ParticipantMessages wording) {
    // The Greek letters are on the same keys.
    return AnswerField.Choice.of(
        List.of(
            ChoiceOption.of("yes", wording.of("yes"), "y\u03C5"),
            ChoiceOption.of("no", wording.of("no"), "n\u03BD")));
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<String> values() {
    return List.of("yes", "no");
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(field(wording));
  }
}
