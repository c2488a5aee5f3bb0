package org.selectiverenderer.statistics.simulation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.FTestResult;
import org.selectiverenderer.statistics.anova.PairwiseComparison;
import org.selectiverenderer.statistics.anova.SignificanceTests;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.study.AreaAnalyser;

/**
 * A power analysis by simulation: many studies of a model are simulated and analysed by the same
 * tests as a real one, on all cores. Study i of a seed is always the same, whichever core computes
 * it.
 *
 * @param area the analysed area; the model may have other areas too
 * @param studies number of studies for each number of participants
 * @param progress receives sentences about the progress
 */
public record PowerAnalysis(
    SimulationModel model,
    String area,
    DetectionMeasure measure,
    DetectionScorer scoring,
    AnovaOptions options,
    int studies,
    long seed,
    Consumer<String> progress) {
  /** The name of the finding that TOST shows equivalence in all comparisons of conditions. */
  public static final String EQUIVALENCE = "equivalence of conditions";

  private static final int REPORTS = 4;

  /** Returns the power of studies with that many participants. */
  public PowerEstimate power(int participants) {
    SimulationModel own = model.of(area);
    AtomicInteger done = new AtomicInteger();
    Object order = new Object();
    AtomicInteger told = new AtomicInteger();
    List<List<String>> found =
        IntStream.range(0, studies)
            .parallel()
            .mapToObj(
                i -> {
                  List<String> findings = findings(own, participants, i);
                  int count = done.incrementAndGet();
                  if (count % Math.max(1, studies / REPORTS) == 0) {
                    synchronized (order) { // so that reported counts increase
                      if (count > told.get()) {
                        told.set(count);
                        progress.accept(
                            "%s: %d of %d studies"
                                .formatted(
                                    Pluralizer.of(participants, "participant"), count, studies));
                      }
                    }
                  }
                  return findings;
                })
            .toList();
    Map<String, Integer> counts = new LinkedHashMap<>();
    names(own).forEach(name -> counts.put(name, 0));
    found.forEach(findings -> findings.forEach(name -> counts.merge(name, 1, Integer::sum)));
    List<PowerEstimate.Finding> findings = new ArrayList<>();
    counts.forEach((name, count) -> findings.add(PowerEstimate.Finding.of(name, count, studies)));
    return new PowerEstimate(participants, studies, findings);
  }

  /** Returns what these studies test: the names of {@link PowerEstimate.Finding}s. */
  public List<String> tested() {
    return names(model.of(area));
  }

  /**
   * The sample size that a target power needs, in equal groups.
   *
   * @param participants the smallest number whose simulated power reaches the target
   * @param low the smallest number whose 95 % interval reaches the target
   * @param high the smallest number whose interval lies above the target; empty if the largest
   *     number tried is not enough
   */
  public record Needed(int participants, int low, OptionalInt high) {}

  /**
   * Returns the smallest number of participants, in equal groups, whose power for a test reaches a
   * target.
   *
   * @param name one of the names in {@link #tested}
   * @param most largest number of participants to try
   * @return empty if the largest number is not enough
   */
  public Optional<Needed> needed(String name, double target, int most) {
    if (!tested().contains(name)) {
      throw new IllegalArgumentException(name + " is not tested");
    }
    int groups = model.conditions().size();
    Map<Integer, PowerEstimate.Finding> known = new HashMap<>();
    IntFunction<PowerEstimate.Finding> finding =
        size -> known.computeIfAbsent(size, own -> power(own * groups).finding(name));
    OptionalInt enough = smallest(1, most / groups, size -> finding.apply(size).share() >= target);
    if (enough.isEmpty()) {
      return Optional.empty();
    }
    int found = enough.getAsInt();
    int low = smallest(1, found, size -> finding.apply(size).high() >= target).orElse(found);
    OptionalInt high = smallest(found, most / groups, size -> finding.apply(size).low() >= target);
    return Optional.of(
        new Needed(
            found * groups,
            low * groups,
            high.isPresent() ? OptionalInt.of(high.getAsInt() * groups) : OptionalInt.empty()));
  }

  /**
   * Returns the smallest group size, at least 2, that is enough, by bisection; larger sizes are
   * assumed to be enough too.
   */
  private static OptionalInt smallest(int from, int most, IntPredicate enough) {
    int low = Math.max(1, from - 1);
    int high = Math.max(2, from);
    while (high > most || !enough.test(high)) {
      if (high >= most) {
        return OptionalInt.empty();
      }
      low = high;
      high = Math.min(2 * high, most);
    }
    while (high - low > 1) {
      int middle = (low + high) / 2;
      if (enough.test(middle)) {
        high = middle;
      } else {
        low = middle;
      }
    }
    return OptionalInt.of(high);
  }

  private List<String> names(SimulationModel own) {
    boolean groups = own.conditions().size() > 1;
    boolean types = own.lists().stream().map(RecognitionListSpec::type).distinct().count() > 1;
    List<String> names = new ArrayList<>();
    if (groups) {
      names.add(AreaAnalyser.BETWEEN);
    }
    if (types) {
      names.add(AreaAnalyser.WITHIN);
    }
    if (groups && types) {
      names.add(AreaAnalyser.WITHIN + " x " + AreaAnalyser.BETWEEN);
    }
    if (groups) {
      names.add(EQUIVALENCE);
    }
    return names;
  }

  private List<String> findings(SimulationModel own, int participants, int study) {
    Responses responses =
        new Responses(
            DataSource.none("simulated"),
            StudySimulator.responses(own, participants, SeedSequence.of(seed, study)),
            List.of());
    return AreaAnalyser.of(responses, scoring, area, List.of(ConfidenceThreshold.ALL))
        .tests(ConfidenceThreshold.ALL, measure, options)
        .map(this::findings)
        .orElse(List.of());
  }

  private List<String> findings(SignificanceTests tests) {
    List<String> findings = new ArrayList<>();
    for (FTestResult effect : tests.effects()) {
      if (effect.p() < options.alpha()) {
        findings.add(effect.term().name());
      }
    }
    List<PairwiseComparison> groups = tests.groups();
    if (!groups.isEmpty() && groups.stream().allMatch(pair -> pair.tost().p() < options.alpha())) {
      findings.add(EQUIVALENCE);
    }
    return findings;
  }
}
