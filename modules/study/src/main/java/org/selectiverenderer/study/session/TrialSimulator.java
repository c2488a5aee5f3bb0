package org.selectiverenderer.study.session;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.formats.csv.SpreadsheetText;
import org.selectiverenderer.study.design.BlockProgress;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialColumns;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialPhase.ResponseKeys;
import org.selectiverenderer.study.design.TrialResult;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.SliderField;

/**
 * Simulates participants who go through the blocks of a study, each in the order of their place in
 * the schedule. A participant has an own level of each measure, and an own reaction to each level
 * of a factor; trials vary around their sum. In a block with a staircase, responses become harder
 * from level to level, down to guessing. The same seed gives the same trials on every machine.
 */
public final class TrialSimulator {
  /** The most rows of a table, so that it fits into the memory. */
  private static final int MOST_ROWS = 500_000;

  /** Mean response time, shortest one, and spreads in milliseconds. */
  private static final double MEAN = 700;

  private static final double QUICKEST = 150;
  private static final double BETWEEN = 100;
  private static final double REACTION = 40;
  private static final double WITHIN = 150;

  /** Probability of a correct response without effects, and at the ends of a staircase. */
  private static final double CORRECT = 0.85;

  private static final double EASIEST = 0.98;
  private static final double GUESSED = 0.5;

  /** Spreads of a scale's answers, as shares of its length. */
  private static final double SCALE_BETWEEN = 0.12;

  private static final double SCALE_REACTION = 0.05;
  private static final double SCALE_WITHIN = 0.15;

  private final LoadedStudy material;
  private final List<SimulatedEffect> effects;
  private final long seed;
  private final List<String> factors;
  private final Set<String> stimuli;
  private final Map<String, List<Question>> asked;

  /** A participant's own deviations, in standard deviations. */
  private static final class Person {
    final Random random;
    final Map<String, Double> deviations = new HashMap<>();

    Person(Random random) {
      this.random = random;
    }

    double deviation(String of) {
      return deviations.computeIfAbsent(of, first -> random.nextGaussian());
    }

    /** Returns the sum of the reactions to the levels of a trial. */
    double reaction(String measure, Trial trial) {
      double sum = 0;
      for (Map.Entry<String, String> level : trial.levels().entrySet()) {
        sum += deviation(measure + '/' + level.getKey() + '/' + level.getValue());
      }
      return sum;
    }
  }

  /**
   * @param effects what the levels do to the measures; none for a study in which they do nothing
   * @param seed of the simulation; the order of the trials is by the study's own
   */
  public TrialSimulator(LoadedStudy material, List<SimulatedEffect> effects, long seed) {
    this.material = material;
    this.effects = List.copyOf(effects);
    this.seed = seed;
    factors = material.study().design().factorNames();
    stimuli = material.study().design().stimulusColumns();
    asked = material.questionsInTrials();
  }

  /** Returns why an effect can do nothing in this study; empty if it can. */
  public Optional<String> fault(SimulatedEffect effect) {
    for (Map.Entry<String, String> pair : effect.at().entrySet()) {
      Optional<Factor> factor =
          material.study().design().factors().stream()
              .filter(each -> each.name().equals(pair.getKey()))
              .findFirst();
      if (factor.isEmpty() && !stimuli.contains(pair.getKey())) {
        return Optional.of(
            "'%s' is neither a factor nor a column of the stimuli".formatted(pair.getKey()));
      }
      if (factor.isPresent() && factor.get().level(pair.getValue()).isEmpty()) {
        return Optional.of(
            "the factor %s has no level '%s'".formatted(pair.getKey(), pair.getValue()));
      }
    }
    boolean known =
        Set.of(SimulatedEffect.MILLISECONDS, SimulatedEffect.CORRECT).contains(effect.measure())
            || asked.values().stream()
                .flatMap(List::stream)
                .anyMatch(
                    question ->
                        question.id().equals(effect.measure())
                            && question.kind().scale().isPresent());
    return known
        ? Optional.empty()
        : Optional.of(
            "'%s' is none of ms, correct and the scales that trials ask"
                .formatted(effect.measure()));
  }

  /**
   * Returns a table of trials as {@code experiment collect --trials} writes it, without practice.
   *
   * @param participants their number; they have the first places of the schedule
   * @throws IllegalArgumentException if the table would have too many rows, or no order of a block
   *     keeps its limits of runs
   */
  public String csv(int participants) {
    CsvWriter table = CsvWriter.bare();
    table.row(header());
    RandomizationSchedule schedule = new RandomizationSchedule(material.study());
    Map<String, Integer> turns = new HashMap<>();
    int rows = 0;
    for (int place = 1; place <= participants; place++) {
      StudyGroup group = schedule.group(place);
      int turn = turns.merge(group.name(), 1, Integer::sum) - 1;
      Person person = new Person(new Random((seed * 1_000_003L + place) * 0x9E3779B97F4A7C15L));
      List<Object> head = List.of(String.format(Locale.ROOT, "%03d", place), 1, group.name());
      for (TrialBlock block : material.study().design().blocks()) {
        BlockProgress progress =
            new BlockProgress(block, group, turn, material.study().seed(), Map.of());
        for (Optional<Trial> next = progress.next(); next.isPresent(); next = progress.next()) {
          Trial trial = next.get();
          TrialResult result = result(block, trial, person);
          List<Object> row = row(head, trial, result, answers(block, trial, person));
          progress.add(result);
          if (block.practice().isEmpty()) {
            table.row(row);
            rows++;
          }
          if (rows > MOST_ROWS) {
            throw new IllegalArgumentException(
                "%d participants would have more than %d trials"
                    .formatted(participants, MOST_ROWS));
          }
        }
      }
    }
    return table.toString();
  }

  private List<Object> header() {
    List<Object> header = new ArrayList<>(TrialColumns.FIRST);
    header.addAll(factors);
    header.addAll(stimuli);
    header.addAll(TrialColumns.RESULT);
    asked.forEach(
        (name, questions) ->
            questions.forEach(question -> header.addAll(TrialsTable.columns(name, question))));
    return header;
  }

  private List<Object> row(
      List<Object> head, Trial trial, TrialResult result, Map<Question, String> answers) {
    List<Object> row = new ArrayList<>(head);
    row.addAll(List.of(trial.block(), trial.number(), trial.round()));
    factors.forEach(factor -> row.add(trial.levels().getOrDefault(factor, "")));
    stimuli.forEach(
        column -> row.add(SpreadsheetText.marked(trial.stimulus().getOrDefault(column, ""))));
    row.add(result.response());
    row.add(
        result.milliseconds().isPresent()
            ? String.format(Locale.ROOT, "%.1f", result.milliseconds().getAsDouble())
            : "");
    row.add(result.correct().map(correct -> correct ? "yes" : "no").orElse(""));
    asked
        .values()
        .forEach(
            questions ->
                questions.forEach(
                    question ->
                        row.addAll(
                            TrialsTable.cells(question, answers.getOrDefault(question, "")))));
    return row;
  }

  private double effect(String measure, Trial trial) {
    return effects.stream()
        .filter(effect -> effect.measure().equals(measure) && effect.concerns(trial))
        .mapToDouble(SimulatedEffect::amount)
        .sum();
  }

  private TrialResult result(TrialBlock block, Trial trial, Person person) {
    ResponseKeys keys = keys(trial.phases());
    String key = trial.filled(keys.correct());
    String response = "";
    OptionalDouble milliseconds = OptionalDouble.empty();
    Optional<Boolean> correct = Optional.empty();
    if (!keys.keys().isEmpty()) {
      String measure = SimulatedEffect.MILLISECONDS;
      milliseconds =
          OptionalDouble.of(
              Math.max(
                  QUICKEST,
                  MEAN
                      + BETWEEN * person.deviation(measure)
                      + REACTION * person.reaction(measure, trial)
                      + effect(measure, trial)
                      + WITHIN * person.random.nextGaussian()));
      boolean right =
          person.random.nextDouble() < ease(block, trial) + effect(SimulatedEffect.CORRECT, trial);
      List<String> wrong = keys.keys().stream().filter(each -> !each.equals(key)).toList();
      if (key.isEmpty()) {
        response = keys.keys().get(person.random.nextInt(keys.keys().size()));
      } else {
        right |= wrong.isEmpty();
        response = right ? key : wrong.get(person.random.nextInt(wrong.size()));
        correct = Optional.of(right);
      }
    }
    return TrialResult.of(trial, response, milliseconds, correct);
  }

  /** Returns the probability of a correct response without effects. */
  private static double ease(TrialBlock block, Trial trial) {
    if (block.staircase().isEmpty()) {
      return CORRECT;
    }
    String varied = block.staircase().get().factor();
    List<String> levels =
        block.factors().stream()
            .filter(factor -> factor.name().equals(varied))
            .flatMap(factor -> factor.levels().stream())
            .map(Factor.Level::name)
            .toList();
    double hardness =
        levels.indexOf(trial.levels().getOrDefault(varied, "")) / Math.max(1.0, levels.size() - 1);
    return EASIEST + hardness * (GUESSED - EASIEST);
  }

  /** Returns the keys of the first phase that has any. */
  private static ResponseKeys keys(List<TrialPhase> phases) {
    for (TrialPhase phase : phases) {
      ResponseKeys keys =
          phase instanceof TrialPhase.Exposure exposure
              ? exposure.response()
              : phase instanceof TrialPhase.Blank blank
                  ? blank.response()
                  : phase instanceof TrialPhase.Repeat repeat
                      ? keys(repeat.phases())
                      : ResponseKeys.NONE;
      if (!keys.keys().isEmpty()) {
        return keys;
      }
    }
    return ResponseKeys.NONE;
  }

  private Map<Question, String> answers(TrialBlock block, Trial trial, Person person) {
    Map<Question, String> answers = new HashMap<>();
    for (TrialPhase phase : block.phases()) {
      if (phase instanceof TrialPhase.Questions questions) {
        asked
            .getOrDefault(questions.questionnaire(), List.of())
            .forEach(question -> answers.put(question, answer(question, trial, person)));
      }
    }
    return answers;
  }

  private String answer(Question question, Trial trial, Person person) {
    Optional<SliderField> scale = question.kind().scale();
    if (scale.isEmpty()) {
      return question.kind().simulated(material.wording(), person.random).value();
    }
    double from = scale.get().from().doubleValue();
    double length = scale.get().to().doubleValue() - from;
    double value =
        from
            + length / 2
            + effect(question.id(), trial)
            + length
                * (SCALE_BETWEEN * person.deviation(question.id())
                    + SCALE_REACTION * person.reaction(question.id(), trial)
                    + SCALE_WITHIN * person.random.nextGaussian());
    return scale.get().nearest(value);
  }
}
