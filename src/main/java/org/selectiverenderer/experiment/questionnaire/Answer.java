package org.selectiverenderer.experiment.questionnaire;

/**
 * What a participant says to a question.
 *
 * @param value as tables have it: {@code yes}, {@code 4}, words; of several choices the values with
 *     {@link AnswerField#SEPARATOR} between them; empty when not given, or taken back
 * @param confidence from 1 to 5; 0 when not yet given, or not asked for
 */
public record Answer(String value, int confidence) {
  /** Nothing said yet. */
  public static final Answer NONE = new Answer("", 0);

  /** A value without confidence. */
  public static Answer of(String value) {
    return new Answer(value, 0);
  }

  /** Whether nothing is wanting. */
  public boolean complete(boolean withConfidence) {
    return !value.isEmpty() && (!withConfidence || confidence > 0);
  }

  /** With another value. */
  public Answer value(String other) {
    return new Answer(other, confidence);
  }

  /** With another confidence. */
  public Answer confidence(int other) {
    return new Answer(value, other);
  }
}
