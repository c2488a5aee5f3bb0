package org.selectiverenderer.experiment.questionnaire;

import java.util.Map;
import java.util.Set;

/**
 * An earlier answer on which a page or a question depends.
 *
 * @param question the id of an earlier question of the same questionnaire
 * @param is values, one of which it must have; of an answer with several values any
 */
public record AskedIf(String question, Set<String> is) {
  public AskedIf {
    is = Set.copyOf(is);
  }

  /** Whether it does, after these answers. */
  boolean holds(Map<String, Answer> answers) {
    String value = answers.getOrDefault(question, Answer.NONE).value();
    return is.contains(value) || AnswerField.Choice.parts(value).stream().anyMatch(is::contains);
  }
}
