package org.selectiverenderer.experiment.questionnaire;

import java.util.List;
import org.selectiverenderer.base.json.JsonMembers;

/** A multiple choice: any number of options; none only if the question is optional. */
record MultipleQuestion(List<Option> options) implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "multiple";

  MultipleQuestion {
    options = List.copyOf(options);
  }

  /** Reads {@code options}. */
  static MultipleQuestion read(JsonMembers keys, Texts texts) {
    return new MultipleQuestion(SingleQuestion.options(keys, texts));
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<String> values() {
    return options.stream().map(Option::value).toList();
  }

  @Override
  public List<AnswerField> fields(Wording wording) {
    return List.of(new AnswerField.Choice(options, true, "", ""));
  }
}
