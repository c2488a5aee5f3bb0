package org.selectiverenderer.study.questionnaire;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.json.JsonObjectReader;

/**
 * A kind of question. Each kind is one class with everything specific to it: keys in files, fields,
 * simulated answers and table.
 */
public sealed interface QuestionKind
    permits RecognitionQuestion,
        ExpectancyQuestion,
        ScaleQuestion,
        BipolarQuestion,
        YesNoQuestion,
        SingleChoiceQuestion,
        MultipleChoiceQuestion,
        TextQuestion,
        NumberQuestion,
        SliderQuestion,
        RankingQuestion,
        GridRowQuestion {

  /** Returns the spelling of the kind in files and tables. */
  String spelling();

  /** Returns the input fields: the value, then the confidence if it is asked for. */
  List<AnswerField> fields(ParticipantMessages wording);

  /**
   * Returns the headings over the fields on a page with questions of this kind alone; may be empty.
   */
  default List<String> headings(ParticipantMessages wording) {
    return List.of();
  }

  /** Returns a random valid answer, for a simulated participant. */
  default Answer simulated(ParticipantMessages wording, Random random) {
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

  /** Returns the id of the grid that the question is a row of; empty if it is of none. */
  default String grid() {
    return "";
  }

  /** Returns the text above all rows of the grid; may be empty. */
  default String stem() {
    return "";
  }

  /** Returns the kind with all occurrences of a text in its stem replaced by another. */
  default QuestionKind naming(String old, String other) {
    return this;
  }

  /** Returns the kind with its options in a participant's random order, if it asks for one. */
  default QuestionKind ordered(Random random) {
    return this;
  }

  /** Returns the pictures that the question shows. */
  default List<Path> pictures() {
    return List.of();
  }

  /** Returns the names of further columns that tables derive from a value; empty for none. */
  default List<String> parts() {
    return List.of();
  }

  /** Returns the cell of a further column; empty without a value. */
  default String part(String name, String value) {
    return "";
  }

  /**
   * Returns the scale of the answers, from whose other end a score may count; empty for kinds whose
   * answers are on no scale.
   */
  default Optional<SliderField> scale() {
    return Optional.empty();
  }

  /** Returns the item that the question is about; empty for kinds that are not about an object. */
  default Optional<StimulusItem> about() {
    return Optional.empty();
  }

  /** Returns the table for the answers. */
  default AnswerTableKind table() {
    return AnswerTableKind.ANSWERS;
  }

  /** Returns the cells of a row of that table. */
  default List<Object> row(Respondent by, String page, Question question, TimedAnswer given) {
    return row(by, page, question.id(), given.answer().value(), given);
  }

  /** Returns the rows of that table that follow, one for each further column of a value. */
  default List<List<Object>> further(
      Respondent by, String page, Question question, TimedAnswer given) {
    return parts().stream()
        .map(
            part ->
                row(
                    by,
                    page,
                    question.id() + "_" + part,
                    part(part, given.answer().value()),
                    given))
        .toList();
  }

  private List<Object> row(
      Respondent by, String page, String question, String value, TimedAnswer given) {
    return List.of(
        by.participant(),
        by.session(),
        by.condition(),
        by.questionnaire(),
        page,
        question,
        spelling(),
        value,
        given.milliseconds(),
        given.placeCell());
  }

  /** Reads the statements of a grid by the ids of its rows, in order. */
  static Map<String, String> rows(JsonObjectReader keys, Texts texts) {
    return GridRowQuestion.rows(keys, texts);
  }

  /** Reads texts in the study's language from a questionnaire's file. */
  interface Texts {
    /** Reads a mandatory text. */
    String text(JsonObjectReader keys, String key);

    /** Reads an optional text; empty if missing. */
    String optional(JsonObjectReader keys, String key);

    /** Reads an optional list of texts; empty if missing. */
    List<String> list(JsonObjectReader keys, String key);

    /** Reads the name of an optional picture; a fault in it is reported. */
    default Optional<Path> picture(JsonObjectReader keys, String key) {
      return Optional.empty();
    }
  }

  /** Spellings of the kinds that a questionnaire's file may use. */
  List<String> IN_FILES =
      List.of(
          ScaleQuestion.SPELLING,
          BipolarQuestion.SPELLING,
          YesNoQuestion.SPELLING,
          SingleChoiceQuestion.SPELLING,
          MultipleChoiceQuestion.SPELLING,
          TextQuestion.SPELLING,
          NumberQuestion.SPELLING,
          SliderQuestion.SPELLING,
          RankingQuestion.SPELLING,
          GridRowQuestion.SPELLING);

  /**
   * Reads the kind of a question and the keys that it has; a grid's is that of its rows.
   *
   * @param id of the question
   * @param text of the question
   * @return empty if there is no such kind, which is then reported
   */
  static Optional<QuestionKind> read(JsonObjectReader keys, Texts texts, String id, String text) {
    String kind = keys.text("kind");
    return switch (kind) {
      case ScaleQuestion.SPELLING -> Optional.of(ScaleQuestion.read(keys, texts));
      case BipolarQuestion.SPELLING -> Optional.of(BipolarQuestion.read(keys, texts));
      case YesNoQuestion.SPELLING -> Optional.of(new YesNoQuestion());
      case SingleChoiceQuestion.SPELLING -> Optional.of(SingleChoiceQuestion.read(keys, texts));
      case MultipleChoiceQuestion.SPELLING -> Optional.of(MultipleChoiceQuestion.read(keys, texts));
      case TextQuestion.SPELLING -> Optional.of(TextQuestion.read(keys));
      case NumberQuestion.SPELLING -> Optional.of(NumberQuestion.read(keys, texts));
      case SliderQuestion.SPELLING -> Optional.of(SliderQuestion.read(keys, texts));
      case RankingQuestion.SPELLING -> Optional.of(RankingQuestion.read(keys, texts));
      case GridRowQuestion.SPELLING ->
          Optional.of(new GridRowQuestion(id, text, GridRowQuestion.options(keys, texts)));
      default -> {
        if (!kind.isEmpty()) {
          keys.fault(
              "kind",
              "there is no kind of question '%s'%s"
                  .formatted(
                      kind,
                      SpellingSuggester.nearest(kind, IN_FILES)
                          .map(near -> "; did you mean '%s'?".formatted(near))
                          .orElse(" (known kinds: %s)".formatted(String.join(", ", IN_FILES)))));
        }
        keys.names(); // Marks all keys as read: those of an unknown kind cannot be checked.
        yield Optional.empty();
      }
    };
  }
}
