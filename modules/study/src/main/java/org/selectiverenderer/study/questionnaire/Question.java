package org.selectiverenderer.study.questionnaire;

import java.util.Optional;
import java.util.Random;

/**
 * A question of a questionnaire.
 *
 * @param id the question's id in tables, unique in the questionnaire; for a question about an
 *     object its name
 * @param text the question's text; may be empty if the fields are labelled
 * @param optional whether the participant may go on without an answer
 * @param when the branching rule; empty for a question that is always asked
 * @param must the only value with which the participant may take part, for consent
 * @param sets the setting of the session that the answer determines
 * @param personal whether the answer is written to the session's journal only, and to no table
 */
public record Question(
    String id,
    String text,
    QuestionKind kind,
    boolean optional,
    Optional<BranchingRule> when,
    Optional<String> must,
    Optional<Sets> sets,
    boolean personal) {

  /** A setting of the session that an answer determines. */
  public enum Sets {
    /** The participant's interpupillary distance in millimetres, for the display. */
    IPD,
    /** The participant's age in {@code participants.tsv}. */
    AGE;

    /** Returns the spelling in files. */
    public String spelling() {
      return name().toLowerCase(java.util.Locale.ROOT);
    }
  }

  /** Returns a mandatory question without branching rule or effect on the session. */
  public static Question of(String id, String text, QuestionKind kind) {
    return new Question(
        id, text, kind, false, Optional.empty(), Optional.empty(), Optional.empty(), false);
  }

  /** Returns the question with all occurrences of a text replaced by another. */
  Question naming(String old, String other) {
    return new Question(
        id,
        text.replace(old, other),
        kind.naming(old, other),
        optional,
        when,
        must,
        sets,
        personal);
  }

  /** Returns the question with its options in a participant's order. */
  Question ordered(Random random) {
    return new Question(id, text, kind.ordered(random), optional, when, must, sets, personal);
  }

  /** Returns whether an answer is complete; an optional question needs none. */
  public boolean complete(Answer answer, ParticipantMessages wording) {
    boolean confident = kind.fields(wording).size() > 1;
    return answer.complete(confident) || optional && answer.equals(Answer.NONE);
  }

  /** Returns whether answers are written to tables. */
  public boolean inTables() {
    return !personal && !kind.example();
  }

  /** Returns whether an answer refuses consent. */
  public boolean refuses(Answer answer) {
    return must.isPresent() && !answer.value().isEmpty() && !answer.value().equals(must.get());
  }
}
