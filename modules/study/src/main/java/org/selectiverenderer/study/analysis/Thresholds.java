package org.selectiverenderer.study.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.statistics.data.Measurement;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.PlannedAnalysis;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialBlock.TrialStaircase;
import org.selectiverenderer.study.design.UpDownStaircase;

/** Thresholds of staircases, found again from a table of trials. */
final class Thresholds {
  private Thresholds() {}

  /** A staircase of a session: the levels of other factors, and the stimulus. */
  private record Track(
      String participant, String session, List<String> levels, List<String> cells) {}

  /**
   * Returns the threshold of each staircase that converged: the mean of the levels' names at the
   * reversals that count, where all of them are numbers, else of the levels' places from 1.
   */
  static List<Measurement> of(
      PlannedAnalysis plan, StudyDesign design, List<CsvRow> rows, List<String> counts) {
    List<Measurement> thresholds = new ArrayList<>();
    int open = 0;
    for (TrialBlock block : design.blocks()) {
      if (block.staircase().isEmpty()) {
        continue;
      }
      TrialStaircase rule = block.staircase().get();
      List<Factor.Level> levels =
          block.factors().stream()
              .filter(factor -> factor.name().equals(rule.factor()))
              .findFirst()
              .orElseThrow()
              .levels();
      Map<Track, UpDownStaircase> tracks = tracks(plan, block, rule, levels.size(), rows);
      for (Map.Entry<Track, UpDownStaircase> each : tracks.entrySet()) {
        double value = value(each.getValue().counting(), levels);
        if (Double.isFinite(value)) {
          thresholds.add(
              new Measurement(each.getKey().participant(), each.getKey().levels(), value));
        } else {
          open++;
        }
      }
    }
    counts.add(Pluralizer.of(thresholds.size(), "staircase") + " converged.");
    if (open > 0) {
      counts.add("%s did not and left out.".formatted(Pluralizer.of(open, "staircase")));
    }
    return thresholds;
  }

  private static Map<Track, UpDownStaircase> tracks(
      PlannedAnalysis plan, TrialBlock block, TrialStaircase rule, int levels, List<CsvRow> rows) {
    List<String> columns = new ArrayList<>(block.factors().stream().map(Factor::name).toList());
    block.stimuli().map(StimulusList::columns).ifPresent(columns::addAll);
    columns.remove(rule.factor());
    Map<Track, UpDownStaircase> tracks = new LinkedHashMap<>();
    for (CsvRow row : rows) {
      if (row.cell("block").equals(block.name())) {
        Track track =
            new Track(
                row.cell("participant"),
                row.cell("session"),
                plan.by().stream().map(row::cellIfAny).toList(),
                columns.stream().map(row::cellIfAny).toList());
        tracks
            .computeIfAbsent(
                track,
                first ->
                    new UpDownStaircase(
                        levels, rule.down(), rule.reversals(), rule.discarded(), rule.most()))
            .answered(row.cell("correct").equals("yes"));
      }
    }
    return tracks;
  }

  private static double value(List<Integer> counting, List<Factor.Level> levels) {
    boolean numbers =
        levels.stream().allMatch(level -> level.name().matches("[0-9]{1,12}(\\.[0-9]{1,12})?"));
    return counting.stream()
        .mapToDouble(level -> numbers ? Double.parseDouble(levels.get(level).name()) : level + 1)
        .average()
        .orElse(Double.NaN);
  }
}
