package org.selectiverenderer.study.questionnaire;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.formats.json.JsonObjectReader;

/** A multiple choice: any number of options; none only if the question is optional. */
record MultipleChoiceQuestion(List<ChoiceOption> options) implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "multiple";

  MultipleChoiceQuestion {
    options = List.copyOf(options);
  }

  /** Reads {@code options}. */
  static MultipleChoiceQuestion read(JsonObjectReader keys, Texts texts) {
    return new MultipleChoiceQuestion(SingleChoiceQuestion.pictured(keys, texts));
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
    return List.of(new AnswerField.Choice(options, true, "", ""));
  }
}
