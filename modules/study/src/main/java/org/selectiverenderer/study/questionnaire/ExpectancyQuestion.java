package org.selectiverenderer.study.questionnaire;

import java.util.List;
import java.util.Optional;

/**
 * A rating of expectancy: how likely is the object in such a place, 1 to 6 (thesis Appendix A, Fig
 * 54).
 */
public record ExpectancyQuestion(StimulusItem item) implements QuestionKind {
  /** Spelling of the kind in files. */
  public static final String SPELLING = "expectancy";

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(
        AnswerField.Choice.numbers(
            1, 6, wording.of("expectancy.least"), wording.of("expectancy.most"), List.of()));
  }

  @Override
  public List<String> headings(ParticipantMessages wording) {
    return List.of(wording.of("expectancy.question"));
  }

  @Override
  public boolean example() {
    return item.example();
  }

  @Override
  public Optional<StimulusItem> about() {
    return Optional.of(item);
  }

  @Override
  public AnswerTableKind table() {
    return AnswerTableKind.RATINGS;
  }

  @Override
  public List<Object> row(Respondent by, String page, Question question, TimedAnswer given) {
    return List.of(
        by.participant(),
        item.area(),
        item.object(),
        item.schema(),
        given.answer().value(),
        given.milliseconds(),
        given.placeCell());
  }
}
