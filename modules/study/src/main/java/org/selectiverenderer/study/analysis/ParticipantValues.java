package org.selectiverenderer.study.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.data.Exclusion;
import org.selectiverenderer.statistics.data.Measurement;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.PlannedAnalysis;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.StudyDesign;

/**
 * The values of a measure as the data of a factorial design.
 *
 * @param within names of the factors that vary within participants
 * @param between names of the others
 * @param data the values of participants who have one at all combinations of levels
 * @param exclusions the others
 */
record ParticipantValues(
    List<String> within, List<String> between, FactorialDesign data, List<Exclusion> exclusions) {
  private static final String ALL = "all";

  ParticipantValues {
    within = List.copyOf(within);
    between = List.copyOf(between);
    exclusions = List.copyOf(exclusions);
  }

  static ParticipantValues of(
      PlannedAnalysis plan, MeasureOfTrials measure, StudyDesign design, StudyTrials trials) {
    List<Integer> inner = new ArrayList<>();
    List<Integer> outer = new ArrayList<>();
    for (int i = 0; i < plan.by().size(); i++) {
      (between(plan.by().get(i), design) ? outer : inner).add(i);
    }
    List<org.selectiverenderer.statistics.anova.Factor> within =
        factors(plan, measure, inner, design);
    List<org.selectiverenderer.statistics.anova.Factor> between =
        factors(plan, measure, outer, design);
    Map<String, Map<List<String>, Double>> values = new LinkedHashMap<>();
    Map<String, Set<List<String>>> groups = new LinkedHashMap<>();
    for (Measurement each : measure.values()) {
      values
          .computeIfAbsent(each.participant(), first -> new LinkedHashMap<>())
          .put(inner.stream().map(each.levels()::get).toList(), each.value());
      groups
          .computeIfAbsent(each.participant(), first -> new LinkedHashSet<>())
          .add(outer.stream().map(each.levels()::get).toList());
    }
    List<List<String>> cells = cells(within, inner.isEmpty());
    List<List<String>> all = cells(between, outer.isEmpty());
    List<Exclusion> exclusions = new ArrayList<>();
    List<Subject> subjects = new ArrayList<>();
    SourceLocation table = SourceLocation.of(trials.table().file());
    Set<String> everybody = new LinkedHashSet<>();
    trials.rows().forEach(row -> everybody.add(row.cell("participant")));
    for (String participant : everybody) {
      Map<List<String>, Double> own = values.getOrDefault(participant, Map.of());
      List<String> missing =
          cells.stream()
              .filter(cell -> !own.containsKey(cell))
              .map(cell -> String.join(", ", cell))
              .toList();
      if (groups.getOrDefault(participant, Set.of()).size() > 1) {
        exclusions.add(
            new Exclusion(table, participant, "is in several groups; the participant is left out"));
      } else if (!missing.isEmpty()) {
        exclusions.add(
            new Exclusion(
                table,
                participant,
                "has no %s%s; the participant is left out"
                    .formatted(
                        plan.measure(),
                        inner.isEmpty() ? "" : " at " + String.join("; ", missing))));
      } else {
        subjects.add(
            new Subject(
                participant,
                all.indexOf(groups.get(participant).iterator().next()),
                cells.stream().map(own::get).toList()));
      }
    }
    return new ParticipantValues(
        inner.stream().map(plan.by()::get).toList(),
        outer.stream().map(plan.by()::get).toList(),
        new FactorialDesign(plan.measure(), within, between, List.of(), subjects),
        exclusions);
  }

  private static boolean between(String factor, StudyDesign design) {
    return factor.equals("group")
        || design.factors().stream()
            .anyMatch(each -> each.name().equals(factor) && each.scope() == Factor.Scope.BETWEEN);
  }

  /** Returns the levels that occur, in the order of the study, else of the table. */
  private static List<String> levels(String factor, List<String> found, StudyDesign design) {
    Set<String> ordered = new LinkedHashSet<>();
    design.factors().stream()
        .filter(each -> each.name().equals(factor))
        .flatMap(each -> each.levels().stream())
        .map(Factor.Level::name)
        .forEach(ordered::add);
    design.blocks().stream()
        .flatMap(block -> block.stimuli().stream())
        .map(StimulusList::rows)
        .flatMap(List::stream)
        .forEach(row -> Optional.ofNullable(row.cells().get(factor)).ifPresent(ordered::add));
    ordered.retainAll(Set.copyOf(found));
    ordered.addAll(found);
    return List.copyOf(ordered);
  }

  private static List<org.selectiverenderer.statistics.anova.Factor> factors(
      PlannedAnalysis plan, MeasureOfTrials measure, List<Integer> places, StudyDesign design) {
    List<org.selectiverenderer.statistics.anova.Factor> factors = new ArrayList<>();
    for (int place : places) {
      List<String> found =
          measure.values().stream().map(each -> each.levels().get(place)).distinct().toList();
      String name = plan.by().get(place);
      factors.add(
          new org.selectiverenderer.statistics.anova.Factor(
              name, found.isEmpty() ? List.of(ALL) : levels(name, found, design)));
    }
    return factors.isEmpty()
        ? List.of(new org.selectiverenderer.statistics.anova.Factor(ALL, List.of(ALL)))
        : factors;
  }

  /** Returns all combinations of levels; the last factor's level changes fastest. */
  private static List<List<String>> cells(
      List<org.selectiverenderer.statistics.anova.Factor> factors, boolean none) {
    List<List<String>> cells = List.of(List.of());
    if (none) {
      return cells;
    }
    for (org.selectiverenderer.statistics.anova.Factor factor : factors) {
      List<List<String>> longer = new ArrayList<>();
      for (List<String> before : cells) {
        for (String level : factor.levels()) {
          List<String> next = new ArrayList<>(before);
          next.add(level);
          longer.add(next);
        }
      }
      cells = longer;
    }
    return cells;
  }
}
