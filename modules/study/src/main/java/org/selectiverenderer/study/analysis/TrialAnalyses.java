package org.selectiverenderer.study.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.data.Exclusion;
import org.selectiverenderer.statistics.data.Measurement;
import org.selectiverenderer.statistics.script.DesignScript;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.PlannedAnalysis;
import org.selectiverenderer.study.design.PlannedAnalysis.Aggregate;
import org.selectiverenderer.study.design.PlannedAnalysis.Test;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.session.LoadedStudy;

/** The analyses of a study's trials: those that it plans, and those that nobody planned. */
public final class TrialAnalyses {
  /** More factors have too many interactions to interpret. */
  private static final int MOST_FACTORS = 5;

  private final LoadedStudy study;
  private final StudyDesign design;
  private final StudyTrials trials;

  /**
   * An analysis with its data.
   *
   * @param planned whether the study plans it
   * @param within names of the factors that vary within participants, in the order of the analysis
   * @param between names of the others
   * @param measured the values, whose levels are in the order of the plan
   * @param data the values of participants who have one at all combinations of levels
   * @param exclusions the others
   */
  public record Analysis(
      PlannedAnalysis plan,
      boolean planned,
      List<String> within,
      List<String> between,
      List<Measurement> values,
      List<Measurement> single,
      List<String> counts,
      FactorialDesign data,
      List<Exclusion> exclusions) {
    public Analysis {
      within = List.copyOf(within);
      between = List.copyOf(between);
      values = List.copyOf(values);
      single = List.copyOf(single);
      counts = List.copyOf(counts);
      exclusions = List.copyOf(exclusions);
    }

    /** Returns what is measured, on which trials, and by which model, in one sentence. */
    public String method() {
      StringBuilder text = new StringBuilder();
      text.append(
          switch (plan.measure()) {
            case PlannedAnalysis.D_PRIME ->
                "d' (z(H) − z(FA), rates corrected log-linearly, Hautus 1995; a signal is %s)"
                    .formatted(cells(plan.signal()));
            case PlannedAnalysis.THRESHOLD ->
                "The threshold (mean of the reversals that count, Levitt 1971)";
            default -> "The %s of %s".formatted(plan.aggregate().spelling(), plan.measure());
          });
      text.append(" of each participant by ").append(String.join(", ", plan.by()));
      if (!plan.where().isEmpty()) {
        text.append(", of trials with ").append(cells(plan.where()));
      }
      text.append(
          plan.test() == Test.MIXED_MODEL
              ? "; a mixed model of single trials by R, beside the analysis of variance of"
                  + " participants' values."
              : "; analysis of variance.");
      return text.toString();
    }

    private static String cells(Map<String, String> cells) {
      return String.join(
          ", ",
          cells.entrySet().stream()
              .map(cell -> cell.getKey() + " = " + cell.getValue())
              .sorted()
              .toList());
    }
  }

  public TrialAnalyses(LoadedStudy study, StudyTrials trials) {
    this.study = study;
    this.trials = trials;
    design = study.study().design();
  }

  /** Returns the analyses that the study plans, in its order. */
  public List<Analysis> planned() {
    return design.analyses().stream().map(plan -> analysis(plan, true)).toList();
  }

  /**
   * Returns the analyses of all numeric measures of each block by all its factors, but those that
   * the study plans.
   */
  public List<Analysis> exploratory() {
    List<Analysis> all = new ArrayList<>();
    for (TrialBlock block : design.blocks()) {
      if (block.practice().isPresent()) {
        continue;
      }
      List<String> by = factors(block);
      if (by.isEmpty()) {
        continue;
      }
      for (String measure : measures(block)) {
        PlannedAnalysis plan = unplanned(block, measure, by);
        if (design.analyses().stream().noneMatch(planned -> same(planned, plan))) {
          all.add(analysis(plan, false));
        }
      }
    }
    return all;
  }

  /** Returns a script for R that repeats analyses from the trials that they have not left out. */
  public static DesignScript script(List<Analysis> analyses) {
    List<DesignScript.Model> models = new ArrayList<>();
    for (Analysis analysis : analyses) {
      // R gets the participants that are analysed here, so that both speak of the same people.
      Set<String> analysed =
          analysis.data().subjects().stream().map(Subject::id).collect(Collectors.toSet());
      List<Measurement> values =
          (analysis.single().isEmpty() ? analysis.values() : analysis.single())
              .stream().filter(value -> analysed.contains(value.participant())).toList();
      models.add(
          new DesignScript.Model(
              analysis.plan().name(),
              analysis.plan().by(),
              analysis.between(),
              analysis.plan().aggregate() == Aggregate.MEDIAN,
              analysis.plan().test() == Test.MIXED_MODEL,
              values.stream().allMatch(each -> each.value() == 0 || each.value() == 1),
              values));
    }
    return new DesignScript(models);
  }

  private static boolean same(PlannedAnalysis planned, PlannedAnalysis other) {
    return planned.measure().equals(other.measure())
        && Set.copyOf(planned.by()).equals(Set.copyOf(other.by()))
        && planned
            .where()
            .getOrDefault("block", other.where().getOrDefault("block", ""))
            .equals(other.where().getOrDefault("block", ""));
  }

  private List<String> factors(TrialBlock block) {
    List<String> by = new ArrayList<>();
    block.factors().stream().map(Factor::name).forEach(by::add);
    block.staircase().ifPresent(staircase -> by.remove(staircase.factor()));
    design.factors().stream()
        .filter(factor -> factor.scope() == Factor.Scope.BETWEEN)
        .map(Factor::name)
        .forEach(by::add);
    if (design.factors().isEmpty() && design.groups().size() > 1) {
      by.add("group");
    }
    return by.subList(0, Math.min(by.size(), MOST_FACTORS));
  }

  private List<String> measures(TrialBlock block) {
    List<String> measures = new ArrayList<>();
    if (block.staircase().isPresent()) {
      measures.add(PlannedAnalysis.THRESHOLD);
    }
    List<String> columns =
        new ArrayList<>(List.of(PlannedAnalysis.MILLISECONDS, PlannedAnalysis.CORRECT));
    for (TrialPhase phase : block.phases()) {
      if (phase instanceof TrialPhase.Questions questions) {
        study.trialQuestions().keySet().stream()
            .filter(column -> column.startsWith(questions.questionnaire() + "."))
            .forEach(columns::add);
      }
    }
    List<CsvRow> rows = trials.rows(Map.of("block", block.name()));
    columns.stream().distinct().filter(column -> numeric(rows, column)).forEach(measures::add);
    return measures;
  }

  private static boolean numeric(List<CsvRow> rows, String column) {
    boolean any = false;
    for (CsvRow row : rows) {
      if (!row.cellIfAny(column).isEmpty()) {
        if (MeasureOfTrials.number(row, column).isEmpty()) {
          return false;
        }
        any = true;
      }
    }
    return any;
  }

  private PlannedAnalysis unplanned(TrialBlock block, String measure, List<String> by) {
    return new PlannedAnalysis(
        "%s of the block %s".formatted(measure, block.name()),
        "",
        measure,
        Map.of("block", block.name()),
        by,
        measure.equals(PlannedAnalysis.CORRECT) ? Aggregate.SHARE : Aggregate.MEAN,
        Map.of(),
        Map.of(),
        Test.ANOVA,
        SourceLocation.of(study.study().file().toString()));
  }

  private Analysis analysis(PlannedAnalysis plan, boolean planned) {
    MeasureOfTrials measure = MeasureOfTrials.of(plan, design, trials);
    ParticipantValues values = ParticipantValues.of(plan, measure, design, trials);
    return new Analysis(
        plan,
        planned,
        values.within(),
        values.between(),
        measure.values(),
        measure.single(),
        measure.counts(),
        values.data(),
        values.exclusions());
  }
}
