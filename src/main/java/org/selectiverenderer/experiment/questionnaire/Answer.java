package org.selectiverenderer.experiment.questionnaire;

/**
 * What a participant says of an object.
 *
 * @param value {@code yes} or {@code no}, or a rating from {@code 1} to {@code 6}; empty when not
 *     yet given
 * @param confidence from 1 to 5; 0 when not yet given, or not asked for
 */
public record Answer(String value, int confidence) {
  /** Nothing said yet. */
  public static final Answer NONE = new Answer("", 0);

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
