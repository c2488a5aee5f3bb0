package org.selectiverenderer.app.replication;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeSet;
import org.selectiverenderer.polygon.SceneStatistics;
import org.selectiverenderer.statistics.anova.CellDescriptives;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.EffectKind;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.distribution.TailProbabilities;
import org.selectiverenderer.statistics.simulation.ScoreTarget;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * What the thesis prints beside what comes out of the replication.
 *
 * @param polygons Tables 3 to 5
 * @param scores Tables 6 to 11, a row for each mean
 * @param kitchen Figs 93 to 98, recomputed from Figs 92 and 96
 * @param effects the tests of Figs 93 to 98 and of 6.5
 * @param totals rows {@code total} of Tables 6 to 11 that are not the mean of their three rows
 */
record ReplicationFindings(
    List<PolygonRow> polygons,
    List<ScoreMean> scores,
    List<KitchenRecomputation.Row> kitchen,
    List<EffectRow> effects,
    List<TotalRow> totals) {
  /** A simulated mean that is off by more standard errors than this is told as not reached. */
  private static final double FAR = 2;

  /** A mean of the tables is cut off after two decimals, so that a mean of three is that exact. */
  private static final double CUT = 0.0101;

  /**
   * @param counted polygons of the scene; empty if it has no such area or state
   */
  record PolygonRow(ThesisTables.PolygonTotal total, OptionalLong counted) {
    boolean asPrinted() {
      return counted.equals(OptionalLong.of(total.printed()));
    }

    boolean asRecomputed() {
      return counted.equals(OptionalLong.of(total.recomputed()));
    }
  }

  /**
   * A mean of Tables 6 to 11.
   *
   * @param present number of present objects of our list, which may differ from the table's
   * @param n simulated participants
   */
  record ScoreMean(
      ThesisTables.ScoreRow row,
      ConfidenceThreshold level,
      DetectionMeasure measure,
      double printed,
      double printedSd,
      double mean,
      double sd,
      int n,
      long present) {
    /** Returns the standard error of the simulated mean. */
    double error() {
      return sd / Math.sqrt(n);
    }

    /** Returns how many standard errors the simulated mean is above the printed one. */
    double distance() {
      return (mean - printed) / error();
    }

    boolean near() {
      return Math.abs(distance()) <= FAR;
    }
  }

  /**
   * A test of the thesis's.
   *
   * @param simulated the same test of the simulated answers; empty if it cannot be made
   * @param printedP p of the printed F
   */
  record EffectRow(
      ThesisTables.PrintedEffect printed, double printedP, Optional<Effect> simulated) {
    boolean agrees() {
      return simulated.isPresent() && simulated.get().p() < 0.05 == printedP < 0.05;
    }
  }

  /** A total of Tables 6 to 11 beside the mean of the three conditions. */
  record TotalRow(
      ThesisTables.ScoreRow row,
      ConfidenceThreshold level,
      DetectionMeasure measure,
      double printed,
      double mean) {}

  static ReplicationFindings of(
      SceneStatistics scene, StudyAnalysis analysis, ReplicatedSessions sessions) {
    return new ReplicationFindings(
        counted(scene),
        means(analysis, sessions),
        KitchenRecomputation.rows(),
        tests(analysis),
        misprintedTotals());
  }

  private static List<PolygonRow> counted(SceneStatistics scene) {
    return ThesisTables.polygons().stream()
        .map(total -> new PolygonRow(total, counted(scene, total)))
        .toList();
  }

  private static OptionalLong counted(SceneStatistics scene, ThesisTables.PolygonTotal total) {
    for (SceneStatistics.ScopeCount scope : scene.scopes()) {
      if (!scope.scope().equalsIgnoreCase(total.area())) {
        continue;
      }
      if (total.schemas().isEmpty()) {
        return OptionalLong.of(scope.high());
      }
      for (SceneStatistics.StateCount state : scope.states()) {
        if (String.join("+", new TreeSet<>(state.schemas())).equals(total.schemas())) {
          return OptionalLong.of(state.polygons());
        }
      }
    }
    return OptionalLong.empty();
  }

  private static List<ScoreMean> means(StudyAnalysis analysis, ReplicatedSessions sessions) {
    List<ScoreMean> all = new ArrayList<>();
    for (ThesisTables.ScoreRow row : ThesisTables.scores()) {
      for (ConfidenceThreshold level : ConfidenceThreshold.values()) {
        for (DetectionMeasure measure :
            List.of(DetectionMeasure.D_PRIME, DetectionMeasure.LOG_BETA)) {
          ScoreTarget target = row.levels().get(level.ordinal());
          boolean d = measure == DetectionMeasure.D_PRIME;
          find(analysis, row.area(), level, measure)
              .flatMap(found -> cell(found, row))
              .ifPresent(
                  cell ->
                      all.add(
                          new ScoreMean(
                              row,
                              level,
                              measure,
                              d ? target.dPrime() : target.logBeta(),
                              d ? target.dPrimeSd() : target.logBetaSd(),
                              cell.mean(),
                              cell.sd(),
                              cell.n(),
                              sessions.present(row.area(), row.type()))));
        }
      }
    }
    return all;
  }

  private static Optional<CellDescriptives> cell(AreaAnalysis found, ThesisTables.ScoreRow row) {
    Optional<String> type =
        row.type().equals("neutral") ? Optional.empty() : Optional.of(row.type());
    Optional<String> condition = row.total() ? Optional.empty() : Optional.of(row.condition());
    return CellDescriptives.of(found.design()).stream()
        .filter(cell -> cell.within().equals(type) && cell.between().equals(condition))
        .findFirst();
  }

  private static Optional<AreaAnalysis> find(
      StudyAnalysis analysis, String area, ConfidenceThreshold level, DetectionMeasure measure) {
    return analysis
        .analyses(area)
        .filter(found -> found.level() == level && found.measure() == measure)
        .findFirst();
  }

  private static List<EffectRow> tests(StudyAnalysis analysis) {
    Map<String, EffectKind> kinds =
        Map.of("type", EffectKind.WITHIN, "condition", EffectKind.BETWEEN);
    return ThesisTables.effects().stream()
        .map(
            printed ->
                new EffectRow(
                    printed,
                    p(printed),
                    find(analysis, printed.area(), printed.level(), printed.measure())
                        .flatMap(AreaAnalysis::anova)
                        .flatMap(anova -> anova.effect(kinds.get(printed.effect())))))
        .toList();
  }

  private static double p(ThesisTables.PrintedEffect printed) {
    return TailProbabilities.f(printed.f(), printed.df1(), printed.df2());
  }

  static List<TotalRow> misprintedTotals() {
    List<TotalRow> all = new ArrayList<>();
    List<ThesisTables.ScoreRow> rows = ThesisTables.scores();
    for (ThesisTables.ScoreRow total : rows) {
      if (!total.total()) {
        continue;
      }
      List<ThesisTables.ScoreRow> own =
          rows.stream()
              .filter(row -> !row.total())
              .filter(row -> row.area().equals(total.area()) && row.type().equals(total.type()))
              .toList();
      for (ConfidenceThreshold level : ConfidenceThreshold.values()) {
        int index = level.ordinal();
        double d = own.stream().mapToDouble(row -> row.levels().get(index).dPrime()).sum();
        double b = own.stream().mapToDouble(row -> row.levels().get(index).logBeta()).sum();
        ScoreTarget printed = total.levels().get(index);
        add(all, total, level, DetectionMeasure.D_PRIME, printed.dPrime(), d / own.size());
        add(all, total, level, DetectionMeasure.LOG_BETA, printed.logBeta(), b / own.size());
      }
    }
    return all;
  }

  private static void add(
      List<TotalRow> all,
      ThesisTables.ScoreRow total,
      ConfidenceThreshold level,
      DetectionMeasure measure,
      double printed,
      double mean) {
    if (Math.abs(printed - mean) > CUT) {
      all.add(new TotalRow(total, level, measure, printed, mean));
    }
  }
}
