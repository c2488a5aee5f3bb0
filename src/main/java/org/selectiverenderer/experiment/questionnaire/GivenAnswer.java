package org.selectiverenderer.experiment.questionnaire;

import java.util.OptionalLong;

/**
 * An answer and how it came about. Times are milliseconds since the question came into view.
 *
 * @param answer the last that was given
 * @param first when a value was given for the first time; empty where nobody measured
 * @param last when the value that counts was given; how sure one is does not change it
 * @param place the question's place on its page in this session, from 1; 0 where it is not known
 * @param personal whether it was said to be for no table when it was given
 */
public record GivenAnswer(
    Answer answer, OptionalLong first, OptionalLong last, int place, boolean personal) {
  /** Not asked, or not answered. */
  public static final GivenAnswer NONE =
      new GivenAnswer(Answer.NONE, OptionalLong.empty(), OptionalLong.empty(), 0, false);

  /** An answer of which nothing else is known. */
  public static GivenAnswer of(Answer answer) {
    return new GivenAnswer(answer, OptionalLong.empty(), OptionalLong.empty(), 0, false);
  }

  /** With another answer in its place, given at a time. */
  public GivenAnswer then(Answer other, OptionalLong at, int where) {
    boolean same = other.value().equals(answer.value());
    OptionalLong earliest = answer.value().isEmpty() ? at : first;
    return new GivenAnswer(
        other, other.value().isEmpty() ? first : earliest, same ? last : at, where, personal);
  }

  /** The same, for no table: what a study's file says of the question later does not change it. */
  public GivenAnswer keptPersonal() {
    return new GivenAnswer(answer, first, last, place, true);
  }

  /** For tables: the time of the value that counts; empty without one. */
  public String milliseconds() {
    return last.isPresent() && !answer.value().isEmpty() ? Long.toString(last.getAsLong()) : "";
  }

  /** For tables. */
  public String placeCell() {
    return place > 0 ? Integer.toString(place) : "";
  }
}
