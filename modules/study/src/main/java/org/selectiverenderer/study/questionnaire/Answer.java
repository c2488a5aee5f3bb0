package org.selectiverenderer.study.questionnaire;

/**
 * A participant's answer to a question.
 *
 * @param value the value as written to tables: {@code yes}, {@code 4}, a text; several choices are
 *     joined by {@link AnswerField#SEPARATOR}; empty if not given, or taken back
 * @param confidence from 1 to 5; 0 if not yet given, or not asked for
 */
public record Answer(String value, int confidence) {
  /** No answer yet. */
  public static final Answer NONE = new Answer("", 0);

  /** Returns an answer without confidence. */
  public static Answer of(String value) {
    return new Answer(value, 0);
  }

  /**
   * Returns whether the answer is complete: it has a value, and a confidence if one is asked for.
   */
  public boolean complete(boolean withConfidence) {
    return !value.isEmpty() && (!withConfidence || confidence > 0);
  }

  /** Returns this answer with another value. */
  public Answer value(String other) {
    return new Answer(other, confidence);
  }

  /** Returns this answer with another confidence. */
  public Answer confidence(int other) {
    return new Answer(value, other);
  }
}
