package org.selectiverenderer.study.questionnaire;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * A recognition question: was the object present, yes or no, with a confidence from 1 to 5 (thesis
 * Appendix D, Fig 86).
 */
record RecognitionQuestion(StimulusItem item) implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "recognition";

  /** Simulated hit rate; with the rate of false alarms d' is about 1.35. */
  private static final double HIT = 0.75;

  private static final double FALSE_ALARM = 0.25;

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    List<String> levels =
        IntStream.rangeClosed(1, 5)
            .mapToObj(level -> wording.of("recognition.confidence." + level))
            .toList();
    return List.of(YesNoQuestion.field(wording), AnswerField.Choice.numbers(1, 5, "", "", levels));
  }

  @Override
  public List<String> headings(ParticipantMessages wording) {
    return List.of(wording.of("recognition.question"), wording.of("recognition.confidence"));
  }

  @Override
  public Answer simulated(ParticipantMessages wording, Random random) {
    boolean yes = random.nextDouble() < (item.present() ? HIT : FALSE_ALARM);
    return new Answer(yes ? "yes" : "no", 1 + random.nextInt(5));
  }

  @Override
  public Optional<StimulusItem> about() {
    return Optional.of(item);
  }

  @Override
  public AnswerTableKind table() {
    return AnswerTableKind.RESPONSES;
  }

  @Override
  public List<Object> row(Respondent by, String page, Question question, TimedAnswer given) {
    Answer answer = given.answer();
    return List.of(
        by.participant(),
        by.condition(),
        item.area(),
        item.object(),
        item.type(),
        item.present() ? "yes" : "no",
        answer.value(),
        answer.confidence() == 0 ? "" : answer.confidence(),
        given.milliseconds(),
        given.placeCell());
  }
}
