package org.selectiverenderer.study.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.apache.commons.math3.stat.descriptive.rank.Median;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.statistics.data.Measurement;
import org.selectiverenderer.statistics.detection.DetectionIndices;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.ResponseCounts;
import org.selectiverenderer.study.design.PlannedAnalysis;
import org.selectiverenderer.study.design.PlannedAnalysis.Limits;
import org.selectiverenderer.study.design.StudyDesign;

/**
 * The values of an analysis's measure.
 *
 * @param single those of single trials, or of single staircases; none for d', which one trial does
 *     not have
 * @param values those of participants at the same levels
 * @param counts how many trials there are and what was left out, in sentences
 */
record MeasureOfTrials(List<Measurement> single, List<Measurement> values, List<String> counts) {

  /** A participant at a combination of levels. */
  private record Cell(String participant, List<String> levels) {
    static Cell of(CsvRow row, PlannedAnalysis plan) {
      return new Cell(row.cell("participant"), plan.by().stream().map(row::cellIfAny).toList());
    }
  }

  MeasureOfTrials {
    single = List.copyOf(single);
    values = List.copyOf(values);
    counts = List.copyOf(counts);
  }

  static MeasureOfTrials of(PlannedAnalysis plan, StudyDesign design, StudyTrials trials) {
    List<String> counts = new ArrayList<>();
    List<CsvRow> chosen = trials.rows(plan.where());
    counts.add(
        chosen.size() == trials.rows().size()
            ? Pluralizer.of(chosen.size(), "trial") + "."
            : "%s of %d.".formatted(Pluralizer.of(chosen.size(), "trial"), trials.rows().size()));
    int before = chosen.size();
    chosen =
        chosen.stream()
            .filter(row -> plan.by().stream().noneMatch(factor -> row.cellIfAny(factor).isEmpty()))
            .toList();
    left(counts, before - chosen.size(), "without a level of " + String.join(", ", plan.by()));
    if (plan.measure().equals(PlannedAnalysis.THRESHOLD)) {
      List<Measurement> staircases = Thresholds.of(plan, design, chosen, counts);
      return new MeasureOfTrials(staircases, combined(plan, staircases), counts);
    }
    for (Map.Entry<String, Limits> limits : plan.exclude().entrySet()) {
      chosen = within(limits.getKey(), limits.getValue(), chosen, counts);
    }
    if (plan.measure().equals(PlannedAnalysis.D_PRIME)) {
      return new MeasureOfTrials(List.of(), sensitivities(plan, chosen, counts), counts);
    }
    List<Measurement> single = new ArrayList<>();
    int missing = 0;
    int wrong = 0;
    for (CsvRow row : chosen) {
      OptionalDouble value = number(row, plan.measure());
      Cell cell = Cell.of(row, plan);
      if (value.isPresent()) {
        single.add(new Measurement(cell.participant(), cell.levels(), value.getAsDouble()));
      } else if (row.cellIfAny(plan.measure()).isEmpty()) {
        missing++;
      } else {
        wrong++;
      }
    }
    left(counts, missing, "without " + plan.measure());
    left(counts, wrong, "whose %s is no number".formatted(plan.measure()));
    return new MeasureOfTrials(single, combined(plan, single), counts);
  }

  /** Returns a cell as a number: 1 for yes, 0 for no. */
  static OptionalDouble number(CsvRow row, String column) {
    String cell = row.cellIfAny(column);
    if (cell.equals("yes") || cell.equals("no")) {
      return OptionalDouble.of(cell.equals("yes") ? 1 : 0);
    }
    if (!cell.matches("[+-]?[0-9]{0,15}([.,][0-9]{1,15})?") || cell.isEmpty()) {
      return OptionalDouble.empty();
    }
    try {
      return OptionalDouble.of(Double.parseDouble(cell.replace(',', '.')));
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }

  private static List<CsvRow> within(
      String column, Limits limits, List<CsvRow> rows, List<String> counts) {
    List<CsvRow> kept = new ArrayList<>();
    int below = 0;
    int above = 0;
    for (CsvRow row : rows) {
      OptionalDouble value = number(row, column);
      if (value.isPresent() && value.getAsDouble() < limits.below()) {
        below++;
      } else if (value.isPresent() && value.getAsDouble() > limits.above()) {
        above++;
      } else {
        kept.add(row);
      }
    }
    if (Double.isFinite(limits.below())) {
      counts.add(told(below, "with %s below %s".formatted(column, plain(limits.below()))));
    }
    if (Double.isFinite(limits.above())) {
      counts.add(told(above, "with %s above %s".formatted(column, plain(limits.above()))));
    }
    return kept;
  }

  private static String plain(double value) {
    return DecimalFormatter.shortest(value);
  }

  /** Tells what was left out, if anything was. */
  static void left(List<String> counts, int number, String which) {
    if (number > 0) {
      counts.add(told(number, which));
    }
  }

  private static String told(int number, String which) {
    return "%s %s left out."
        .formatted(Pluralizer.of(number, "trial"), which)
        .replaceFirst("^0 trials", "No trial");
  }

  private static List<Measurement> combined(PlannedAnalysis plan, List<Measurement> single) {
    Map<Cell, List<Double>> all = new LinkedHashMap<>();
    for (Measurement each : single) {
      all.computeIfAbsent(new Cell(each.participant(), each.levels()), first -> new ArrayList<>())
          .add(each.value());
    }
    List<Measurement> combined = new ArrayList<>();
    all.forEach(
        (cell, values) -> {
          double[] numbers = values.stream().mapToDouble(Double::doubleValue).toArray();
          combined.add(
              new Measurement(
                  cell.participant(),
                  cell.levels(),
                  plan.aggregate() == PlannedAnalysis.Aggregate.MEDIAN
                      ? new Median().evaluate(numbers)
                      : values.stream().mapToDouble(Double::doubleValue).sum() / numbers.length));
        });
    return combined;
  }

  /**
   * Returns d' of each participant: a hit is a correct response to a signal, a false alarm a wrong
   * one to its absence. Rates are corrected log-linearly (Hautus 1995). Trials without a response
   * are left out.
   */
  private static List<Measurement> sensitivities(
      PlannedAnalysis plan, List<CsvRow> rows, List<String> counts) {
    Map<Cell, int[]> outcomes = new LinkedHashMap<>();
    int missing = 0;
    Map.Entry<String, String> signal = plan.signal().entrySet().iterator().next();
    for (CsvRow row : rows) {
      String correct = row.cell("correct");
      if (row.cell("response").isEmpty() || correct.isEmpty()) {
        missing++;
        continue;
      }
      boolean present = row.cellIfAny(signal.getKey()).equals(signal.getValue());
      boolean yes = present == correct.equals("yes");
      outcomes
          .computeIfAbsent(Cell.of(row, plan), first -> new int[4])[
          (present ? 0 : 2) + (yes ? 0 : 1)]++;
    }
    left(counts, missing, "without a response that is right or wrong");
    List<Measurement> values = new ArrayList<>();
    int undefined = 0;
    for (Map.Entry<Cell, int[]> each : outcomes.entrySet()) {
      int[] found = each.getValue();
      DetectionIndices indices =
          DetectionIndices.of(
              new ResponseCounts(found[0], found[1], found[2], found[3]),
              ExtremeRateCorrection.LOG_LINEAR);
      if (Double.isFinite(indices.dPrime())) {
        values.add(
            new Measurement(each.getKey().participant(), each.getKey().levels(), indices.dPrime()));
      } else {
        undefined++;
      }
    }
    Optional.of(undefined)
        .filter(number -> number > 0)
        .ifPresent(
            number ->
                counts.add(
                    "%s of a participant without trials with a signal, or without trials without one, left out."
                        .formatted(Pluralizer.of(number, "cell"))));
    return values;
  }
}
