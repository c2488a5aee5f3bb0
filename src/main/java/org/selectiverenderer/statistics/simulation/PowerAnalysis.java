package org.selectiverenderer.statistics.simulation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.selectiverenderer.base.decimal.Counted;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Comparison;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.data.DataFile;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.detection.ConfidenceLevel;
import org.selectiverenderer.statistics.detection.Measure;
import org.selectiverenderer.statistics.detection.Scoring;
import org.selectiverenderer.statistics.study.AreaStudy;

/**
 * Power by simulation: many studies of a model, each through the same analysis as a real one, on
 * all cores. Study i of a seed is always the same, whichever core makes it.
 *
 * @param area analysed; the model may ask about others too
 * @param studies for each number of participants
 * @param progress hears sentences
 */
public record PowerAnalysis(
    StudyModel model,
    String area,
    Measure measure,
    Scoring scoring,
    AnovaOptions options,
    int studies,
    long seed,
    Consumer<String> progress) {
  /** All comparisons of conditions show equivalence by TOST. */
  public static final String EQUIVALENCE = "equivalence of conditions";

  private static final int REPORTS = 4;

  /** The power of studies of that many participants. */
  public Power power(int participants) {
    StudyModel own = model.of(area);
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
                    synchronized (order) { // Numbers only ever grow.
                      if (count > told.get()) {
                        told.set(count);
                        progress.accept(
                            "%s: %d of %d studies"
                                .formatted(
                                    Counted.of(participants, "participant"), count, studies));
                      }
                    }
                  }
                  return findings;
                })
            .toList();
    Map<String, Integer> counts = new LinkedHashMap<>();
    names(own).forEach(name -> counts.put(name, 0));
    found.forEach(findings -> findings.forEach(name -> counts.merge(name, 1, Integer::sum)));
    List<Power.Finding> findings = new ArrayList<>();
    counts.forEach((name, count) -> findings.add(Power.Finding.of(name, count, studies)));
    return new Power(participants, studies, findings);
  }

  /**
   * The smallest number of participants, in equal groups, whose power for something reaches a
   * target.
   *
   * @param name of a {@link Power.Finding}
   * @param most to be tried
   * @return empty if that many are not enough
   */
  public OptionalInt needed(String name, double target, int most) {
    int groups = model.conditions().size();
    IntPredicate enough = size -> power(size * groups).share(name) >= target;
    int low = 1;
    int high = 2;
    while (!enough.test(high)) {
      low = high;
      high = Math.min(2 * high, most / groups);
      if (high <= low) {
        return OptionalInt.empty();
      }
    }
    while (high - low > 1) {
      int middle = (low + high) / 2;
      if (enough.test(middle)) {
        high = middle;
      } else {
        low = middle;
      }
    }
    return OptionalInt.of(high * groups);
  }

  private List<String> names(StudyModel own) {
    boolean groups = own.conditions().size() > 1;
    boolean types = own.lists().stream().map(ObjectList::type).distinct().count() > 1;
    List<String> names = new ArrayList<>();
    if (groups) {
      names.add(AreaStudy.BETWEEN);
    }
    if (types) {
      names.add(AreaStudy.WITHIN);
    }
    if (groups && types) {
      names.add(AreaStudy.WITHIN + " x " + AreaStudy.BETWEEN);
    }
    if (groups) {
      names.add(EQUIVALENCE);
    }
    return names;
  }

  private List<String> findings(StudyModel own, int participants, int study) {
    Responses responses =
        new Responses(
            DataFile.none("simulated"),
            SimulatedStudy.responses(own, participants, Seeds.of(seed, study)),
            List.of());
    List<String> findings = new ArrayList<>();
    AreaStudy.of(responses, scoring, area)
        .analysis(ConfidenceLevel.ALL, measure, options)
        .anova()
        .ifPresent(anova -> add(anova, findings));
    return findings;
  }

  private void add(Anova anova, List<String> findings) {
    for (Effect effect : anova.effects()) {
      if (effect.p() < options.alpha()) {
        findings.add(effect.name());
      }
    }
    List<Comparison> groups =
        anova.comparisons().stream()
            .filter(pair -> pair.factor().equals(AreaStudy.BETWEEN) && pair.at().isEmpty())
            .toList();
    if (!groups.isEmpty() && groups.stream().allMatch(pair -> pair.tost().p() < options.alpha())) {
      findings.add(EQUIVALENCE);
    }
  }
}
