package org.selectiverenderer.study.questionnaire;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.selectiverenderer.formats.json.JsonObjectReader;

/**
 * A question whose answer is an order of options.
 *
 * @param shuffled whether each participant sees the options in a random order first
 */
record RankingQuestion(List<ChoiceOption> options, boolean shuffled) implements QuestionKind {
  /** Spelling of the kind in files. */
  static final String SPELLING = "ranking";

  /** Largest number of options, as many as can be compared and seen at once. */
  private static final int MOST_OPTIONS = 20;

  RankingQuestion {
    options = List.copyOf(options);
  }

  /** Reads {@code options} and {@code order}. */
  static RankingQuestion read(JsonObjectReader keys, Texts texts) {
    List<ChoiceOption> options = SingleChoiceQuestion.options(keys, texts);
    if (options.size() > MOST_OPTIONS) {
      keys.fault(
          "options",
          "a ranking may have %d options; this one has %d".formatted(MOST_OPTIONS, options.size()));
    }
    return new RankingQuestion(
        options,
        keys.choice("order", List.of(false, true), random -> random ? "random" : "fixed", false));
  }

  @Override
  public String spelling() {
    return SPELLING;
  }

  @Override
  public List<AnswerField> fields(ParticipantMessages wording) {
    return List.of(new RankingField(options));
  }

  @Override
  public QuestionKind ordered(Random random) {
    if (!shuffled) {
      return this;
    }
    List<ChoiceOption> order = new ArrayList<>(options);
    Collections.shuffle(order, random);
    return new RankingQuestion(order, false);
  }

  @Override
  public List<String> parts() {
    return options.stream().map(ChoiceOption::value).sorted().toList();
  }

  @Override
  public String part(String name, String value) {
    int rank = AnswerField.Choice.parts(value).indexOf(name) + 1;
    return rank == 0 ? "" : Integer.toString(rank);
  }
}
