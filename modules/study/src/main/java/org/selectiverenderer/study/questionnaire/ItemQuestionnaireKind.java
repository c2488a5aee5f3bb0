package org.selectiverenderer.study.questionnaire;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/** The kinds of questionnaires of the thesis that ask one question about each object of a table. */
public enum ItemQuestionnaireKind {
  /** {@link RecognitionQuestion}. */
  RECOGNITION(List.of("area", "object", "consistency", "present"), RecognitionQuestion::new),
  /** {@link ExpectancyQuestion}. */
  EXPECTANCY(List.of("area", "schema", "object"), ExpectancyQuestion::new);

  private final List<String> columns;
  private final Function<StimulusItem, QuestionKind> question;

  ItemQuestionnaireKind(List<String> columns, Function<StimulusItem, QuestionKind> question) {
    this.columns = columns;
    this.question = question;
  }

  /** Returns the spelling in the study file, which is also the questionnaire's default name. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns the columns of the table, other than those of the objects' names. */
  public List<String> columns() {
    return columns;
  }

  /** Returns the question about an object. */
  public Question question(StimulusItem item, String name) {
    return Question.of(item.object(), name, question.apply(item));
  }
}
