package org.selectiverenderer.study.analysis;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.FTestResult;
import org.selectiverenderer.statistics.anova.SignificanceTests;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.simulation.PowerEstimate;
import org.selectiverenderer.study.analysis.TrialAnalyses.Analysis;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SimulatedEffect;
import org.selectiverenderer.study.session.TrialSimulator;

/**
 * The power of the analyses that a study plans: how often studies of the same design, with
 * simulated participants, find each effect. A mixed model is represented by the analysis of
 * variance of participants' values.
 *
 * @param participants number of participants of each study
 * @param studies number of simulated studies
 * @param effects the tested effects, in the order of the plan
 */
public record PlannedPower(int participants, int studies, List<Tested> effects) {
  /** Seeds of studies are this far apart; those of participants lie between. */
  private static final long APART = 1_000_003L;

  /** How many studies are simulated between two lines of progress. */
  private static final int STEP = 100;

  /**
   * An effect of an analysis.
   *
   * @param finding the share of studies that find it, and its interval
   * @param untested number of studies in which it could not be tested
   */
  public record Tested(String analysis, PowerEstimate.Finding finding, int untested) {}

  private record Effect(String analysis, String name) {}

  public PlannedPower {
    effects = List.copyOf(effects);
  }

  /**
   * Simulates studies.
   *
   * @param simulated what the levels do to the measures
   * @param seed the same seed gives the same figures on any number of cores
   * @param progress is told how far it is
   * @throws IllegalArgumentException if a study would have too many trials
   */
  public static PlannedPower of(
      LoadedStudy study,
      List<SimulatedEffect> simulated,
      AnovaOptions options,
      int participants,
      int studies,
      long seed,
      Consumer<String> progress) {
    Map<Effect, Integer> found = new LinkedHashMap<>();
    Map<Effect, Integer> tested = new LinkedHashMap<>();
    for (int first = 0; first < studies; first += STEP) {
      int end = Math.min(studies, first + STEP);
      List<Map<Effect, Double>> all =
          IntStream.range(first, end)
              .parallel()
              .mapToObj(i -> one(study, simulated, options, participants, seed * APART + i))
              .toList();
      for (Map<Effect, Double> each : all) {
        each.forEach(
            (effect, p) -> {
              found.merge(effect, p < options.alpha() ? 1 : 0, Integer::sum);
              tested.merge(effect, Double.isNaN(p) ? 0 : 1, Integer::sum);
            });
      }
      progress.accept("%d of %d studies".formatted(end, studies));
    }
    List<Tested> effects = new ArrayList<>();
    found.forEach(
        (effect, number) ->
            effects.add(
                new Tested(
                    effect.analysis(),
                    PowerEstimate.Finding.of(effect.name(), number, studies),
                    studies - tested.getOrDefault(effect, 0))));
    return new PlannedPower(participants, studies, effects);
  }

  /** Returns p of each effect in one study; NaN where it cannot be tested. */
  private static Map<Effect, Double> one(
      LoadedStudy study,
      List<SimulatedEffect> simulated,
      AnovaOptions options,
      int participants,
      long seed) {
    byte[] trials =
        new TrialSimulator(study, simulated, seed)
            .csv(participants)
            .getBytes(StandardCharsets.UTF_8);
    StudyTrials read =
        StudyTrials.read(
                "simulated trials",
                trials,
                DataSource.none("simulated trials"),
                study.study().design(),
                new ProblemCollector())
            .orElseThrow();
    Map<Effect, Double> found = new LinkedHashMap<>();
    for (Analysis analysis : new TrialAnalyses(study, read).planned()) {
      if (analysis.data().obstacle().isEmpty()) {
        for (FTestResult test : SignificanceTests.of(analysis.data(), options).effects()) {
          found.put(new Effect(analysis.plan().name(), test.term().name()), test.p());
        }
      }
    }
    return found;
  }
}
