package org.selectiverenderer.experiment.questionnaire;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.selectiverenderer.base.json.JsonMembers;
import org.selectiverenderer.base.problem.Spelling;

/**
 * What a question is like. Each kind is one class, which says all there is to say of it; this is
 * the list of them.
 */
public sealed interface QuestionKind
    permits Recognition,
        Expectancy,
        ScaleQuestion,
        BipolarQuestion,
        YesNoQuestion,
        SingleQuestion,
        MultipleQuestion,
        TextQuestion,
        NumberQuestion {

  /** As files and tables spell it. */
  String spelling();

  /** What is to be filled in: the value, and then how sure one is, where that is asked, too. */
  List<AnswerField> fields(Wording wording);

  /** What stands over the fields, where a page has questions of this kind alone; may be nothing. */
  default List<String> headings(Wording wording) {
    return List.of();
  }

  /** What somebody might answer. */
  default Answer simulated(Wording wording, Random random) {
    List<AnswerField> fields = fields(wording);
    return new Answer(
        fields.get(0).simulated(random),
        fields.size() < 2 ? 0 : Integer.parseInt(fields.get(1).simulated(random)));
  }

  /** Whether it only shows how to answer, so that its answers count nowhere. */
  default boolean example() {
    return false;
  }

  /** All values that an answer may choose from; empty for words and numbers of one's own. */
  default List<String> values() {
    return List.of();
  }

  /** The numbers that are allowed; empty for kinds whose answers are none. */
  default Optional<AnswerField.Line.Range> numbers() {
    return Optional.empty();
  }

  /** The object that it asks about; empty for kinds that ask about none. */
  default Optional<QuestionItem> about() {
    return Optional.empty();
  }

  /** The table that has its answers. */
  default AnswerTable table() {
    return AnswerTable.ANSWERS;
  }

  /** Cells of a row of that table. */
  default List<Object> row(AskedBy by, String page, Question question, GivenAnswer given) {
    return List.of(
        by.participant(),
        by.session(),
        by.condition(),
        by.questionnaire(),
        page,
        question.id(),
        spelling(),
        given.answer().value(),
        given.milliseconds(),
        given.placeCell());
  }

  /** The words of the language in which a questionnaire's file is read. */
  interface Texts {
    /** A text that must be there. */
    String text(JsonMembers keys, String key);

    /** A text that may be missing, and is empty then. */
    String optional(JsonMembers keys, String key);

    /** A list of texts that may be missing, and is empty then. */
    List<String> list(JsonMembers keys, String key);
  }

  /** The kinds that a questionnaire's file may have. */
  List<String> IN_FILES =
      List.of(
          ScaleQuestion.SPELLING,
          BipolarQuestion.SPELLING,
          YesNoQuestion.SPELLING,
          SingleQuestion.SPELLING,
          MultipleQuestion.SPELLING,
          TextQuestion.SPELLING,
          NumberQuestion.SPELLING);

  /**
   * Reads the kind of a question and the keys that it has.
   *
   * @return empty when there is no such kind, which is then told
   */
  static Optional<QuestionKind> read(JsonMembers keys, Texts texts) {
    String kind = keys.text("kind");
    return switch (kind) {
      case ScaleQuestion.SPELLING -> Optional.of(ScaleQuestion.read(keys, texts));
      case BipolarQuestion.SPELLING -> Optional.of(BipolarQuestion.read(keys, texts));
      case YesNoQuestion.SPELLING -> Optional.of(new YesNoQuestion());
      case SingleQuestion.SPELLING -> Optional.of(SingleQuestion.read(keys, texts));
      case MultipleQuestion.SPELLING -> Optional.of(MultipleQuestion.read(keys, texts));
      case TextQuestion.SPELLING -> Optional.of(TextQuestion.read(keys));
      case NumberQuestion.SPELLING -> Optional.of(NumberQuestion.read(keys, texts));
      default -> {
        if (!kind.isEmpty()) {
          keys.fault(
              "kind",
              "there is no kind of question '%s'%s"
                  .formatted(
                      kind,
                      Spelling.nearest(kind, IN_FILES)
                          .map(near -> "; did you mean '%s'?".formatted(near))
                          .orElse(" (known kinds: %s)".formatted(String.join(", ", IN_FILES)))));
        }
        keys.names(); // What such a kind would have is not known.
        yield Optional.empty();
      }
    };
  }
}
