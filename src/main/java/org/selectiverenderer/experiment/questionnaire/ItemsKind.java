package org.selectiverenderer.experiment.questionnaire;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/** The questionnaires of the thesis, which ask one question of each object of a table. */
public enum ItemsKind {
  /** {@link Recognition}. */
  RECOGNITION(List.of("area", "object", "consistency", "present"), Recognition::new),
  /** {@link Expectancy}. */
  EXPECTANCY(List.of("area", "schema", "object"), Expectancy::new);

  private final List<String> columns;
  private final Function<QuestionItem, QuestionKind> question;

  ItemsKind(List<String> columns, Function<QuestionItem, QuestionKind> question) {
    this.columns = columns;
    this.question = question;
  }

  /** As the study file spells it, and the name of the questionnaire. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Columns of the table, beside those of the names. */
  public List<String> columns() {
    return columns;
  }

  /** The question of an object. */
  public Question question(QuestionItem item, String name) {
    return Question.of(item.object(), name, question.apply(item));
  }
}
