package org.selectiverenderer.experiment.questionnaire;

import java.util.Optional;

/**
 * A question.
 *
 * @param id by which tables know it, once in its questionnaire: of an object its name
 * @param text what is asked; may be empty where the fields say all
 * @param optional whether one may go on without an answer
 * @param when what it depends on
 * @param must the value that alone lets one take part, for consent
 * @param sets what of the session the answer decides
 * @param personal whether the answer stays in the session's journal and comes into no table
 */
public record Question(
    String id,
    String text,
    QuestionKind kind,
    boolean optional,
    Optional<AskedIf> when,
    Optional<String> must,
    Optional<Sets> sets,
    boolean personal) {

  /** What an answer may decide. */
  public enum Sets {
    /** The distance of the participant's pupils in millimetres, for the display. */
    IPD,
    /** The age in the list of participants. */
    AGE;

    /** As files spell it. */
    public String spelling() {
      return name().toLowerCase(java.util.Locale.ROOT);
    }
  }

  /** A question that must be answered and does nothing else. */
  public static Question of(String id, String text, QuestionKind kind) {
    return new Question(
        id, text, kind, false, Optional.empty(), Optional.empty(), Optional.empty(), false);
  }

  /** With a text in the place of another. */
  Question naming(String old, String other) {
    return new Question(id, text.replace(old, other), kind, optional, when, must, sets, personal);
  }

  /** Whether nothing of an answer is wanting. */
  public boolean complete(Answer answer, Wording wording) {
    boolean confident = kind.fields(wording).size() > 1;
    return answer.complete(confident) || optional && answer.equals(Answer.NONE);
  }

  /** Whether answers come into tables. */
  public boolean inTables() {
    return !personal && !kind.example();
  }

  /** Whether an answer forbids to take part. */
  public boolean refuses(Answer answer) {
    return must.isPresent() && !answer.value().isEmpty() && !answer.value().equals(must.get());
  }
}
