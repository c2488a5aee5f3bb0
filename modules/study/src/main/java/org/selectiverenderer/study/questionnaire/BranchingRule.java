package org.selectiverenderer.study.questionnaire;

import java.util.Map;
import java.util.Set;

/**
 * A branching rule (skip logic): a page or a question is shown only if an earlier question has one
 * of some answers.
 *
 * @param question the id of an earlier question of the same questionnaire
 * @param is the values of which the answer must have at least one
 */
public record BranchingRule(String question, Set<String> is) {
  public BranchingRule {
    is = Set.copyOf(is);
  }

  /** Returns whether the rule holds for these answers. */
  boolean holds(Map<String, Answer> answers) {
    String value = answers.getOrDefault(question, Answer.NONE).value();
    return is.contains(value) || AnswerField.Choice.parts(value).stream().anyMatch(is::contains);
  }
}
