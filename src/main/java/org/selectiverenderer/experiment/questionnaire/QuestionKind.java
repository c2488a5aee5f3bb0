package org.selectiverenderer.experiment.questionnaire;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.selectiverenderer.base.json.JsonMembers;
import org.selectiverenderer.base.problem.Spelling;

/**
 * A kind of question. Each kind is one class with everything specific to it: keys in files, fields,
 * simulated answers and table.
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

  /** Returns the spelling of the kind in files and tables. */
  String spelling();

  /** Returns the input fields: the value, then the confidence if it is asked for. */
  List<AnswerField> fields(Wording wording);

  /**
   * Returns the headings over the fields on a page with questions of this kind alone; may be empty.
   */
  default List<String> headings(Wording wording) {
    return List.of();
  }

  /** Returns a random valid answer, for a simulated participant. */
  default Answer simulated(Wording wording, Random random) {
    List<AnswerField> fields = fields(wording);
    return new Answer(
        fields.get(0).simulated(random),
        fields.size() < 2 ? 0 : Integer.parseInt(fields.get(1).simulated(random)));
  }

  /** Returns whether the question is an example, whose answers do not count. */
  default boolean example() {
    return false;
  }

  /** Returns all possible values; empty for texts and free numbers. */
  default List<String> values() {
    return List.of();
  }

  /** Returns the range of valid numbers; empty for kinds whose answers are not numbers. */
  default Optional<AnswerField.Line.Range> numbers() {
    return Optional.empty();
  }

  /** Returns the item that the question is about; empty for kinds that are not about an object. */
  default Optional<QuestionItem> about() {
    return Optional.empty();
  }

  /** Returns the table for the answers. */
  default AnswerTable table() {
    return AnswerTable.ANSWERS;
  }

  /** Returns the cells of a row of that table. */
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

  /** Reads texts in the study's language from a questionnaire's file. */
  interface Texts {
    /** Reads a mandatory text. */
    String text(JsonMembers keys, String key);

    /** Reads an optional text; empty if missing. */
    String optional(JsonMembers keys, String key);

    /** Reads an optional list of texts; empty if missing. */
    List<String> list(JsonMembers keys, String key);
  }

  /** Spellings of the kinds that a questionnaire's file may use. */
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
   * @return empty if there is no such kind, which is then reported
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
        keys.names(); // Marks all keys as read: those of an unknown kind cannot be checked.
        yield Optional.empty();
      }
    };
  }
}
