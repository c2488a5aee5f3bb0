package org.selectiverenderer.study.questionnaire;

import java.util.List;
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
        SliderQuestion {

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
    String text(JsonObjectReader keys, String key);

    /** Reads an optional text; empty if missing. */
    String optional(JsonObjectReader keys, String key);

    /** Reads an optional list of texts; empty if missing. */
    List<String> list(JsonObjectReader keys, String key);
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
          SliderQuestion.SPELLING);

  /**
   * Reads the kind of a question and the keys that it has.
   *
   * @return empty if there is no such kind, which is then reported
   */
  static Optional<QuestionKind> read(JsonObjectReader keys, Texts texts) {
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
