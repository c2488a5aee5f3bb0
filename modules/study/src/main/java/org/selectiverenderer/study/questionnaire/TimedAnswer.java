package org.selectiverenderer.study.questionnaire;

import java.util.OptionalLong;

/**
 * An answer with its response times, in milliseconds since the question came into view.
 *
 * @param answer the last answer
 * @param first time of the first value; empty if not measured
 * @param last time of the value that counts, whenever its confidence was given; empty if not
 *     measured
 * @param place place of the question on its page in this session, from 1; 0 if unknown
 * @param personal whether the question was marked as personal when it was answered, so that the
 *     answer is written to no table
 */
public record TimedAnswer(
    Answer answer, OptionalLong first, OptionalLong last, int place, boolean personal) {
  /** No answer: the question was not asked, or not answered. */
  public static final TimedAnswer NONE =
      new TimedAnswer(Answer.NONE, OptionalLong.empty(), OptionalLong.empty(), 0, false);

  /** Returns an answer without response times. */
  public static TimedAnswer of(Answer answer) {
    return new TimedAnswer(answer, OptionalLong.empty(), OptionalLong.empty(), 0, false);
  }

  /** Returns the answer after a change, made at a time. */
  public TimedAnswer then(Answer other, OptionalLong at, int where) {
    boolean same = other.value().equals(answer.value());
    OptionalLong earliest = answer.value().isEmpty() ? at : first;
    return new TimedAnswer(
        other, other.value().isEmpty() ? first : earliest, same ? last : at, where, personal);
  }

  /**
   * Returns this answer marked as personal: a later change of the study's file does not unmark it.
   */
  public TimedAnswer keptPersonal() {
    return new TimedAnswer(answer, first, last, place, true);
  }

  /** Returns this answer with another place of its question; one of an unknown place keeps that. */
  TimedAnswer placed(int where) {
    return place > 0 ? new TimedAnswer(answer, first, last, where, personal) : this;
  }

  /** Returns the table cell of the response time; empty without a value. */
  public String milliseconds() {
    return last.isPresent() && !answer.value().isEmpty() ? Long.toString(last.getAsLong()) : "";
  }

  /** Returns the table cell of the place. */
  public String placeCell() {
    return place > 0 ? Integer.toString(place) : "";
  }
}
