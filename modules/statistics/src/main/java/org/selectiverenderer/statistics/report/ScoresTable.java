package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.statistics.anova.CellDescriptives;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScore;
import org.selectiverenderer.statistics.detection.Response;
import org.selectiverenderer.statistics.report.ReportBlock.Table;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Builds the table of means and standard deviations (in brackets) of d' and log beta at the three
 * levels of confidence: Tables 6 to 11 of the thesis. The criterion c, which those tables lack, is
 * in the details of the report.
 */
final class ScoresTable {
  private static final List<DetectionMeasure> MEASURES =
      List.of(DetectionMeasure.D_PRIME, DetectionMeasure.LOG_BETA);
  private static final Optional<String> ONE =
      Optional.of("one participant has no standard deviation");
  private static final String NONE = "no participant has this score";

  private final StudyAnalysis study;
  private final String area;
  private final List<AreaAnalysis> columns;

  private ScoresTable(StudyAnalysis study, String area) {
    this.study = study;
    this.area = area;
    columns =
        study.analyses(area).filter(analysis -> MEASURES.contains(analysis.measure())).toList();
  }

  static Table of(StudyAnalysis study, String area) {
    return new ScoresTable(study, area).table();
  }

  private Table table() {
    List<String> header = new ArrayList<>(List.of("condition"));
    for (AreaAnalysis column : columns) {
      header.add(column.measure().symbol() + " " + column.level().heading());
      if (closesLevel(column)) {
        header.add("n");
      }
    }
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    for (String type : columns.get(0).design().within().levels()) {
      rows.add(List.of("%s objects (O = %d)".formatted(type, present(type))));
      for (String condition : study.conditions()) {
        rows.add(row(condition, type, Optional.of(condition), figures));
      }
      if (study.conditions().size() > 1) {
        rows.add(row("total", type, Optional.empty(), figures));
      }
    }
    List<String> notes = new ArrayList<>(figures.notes());
    notes.add("O: objects that were present; absent ones were asked for too. " + participants());
    return new Table(
        area + ": mean (standard deviation) of d′ and log β by condition", header, rows, notes);
  }

  /**
   * Returns the note that states n of each column; participants without a score are named in the
   * details.
   */
  private String participants() {
    int all = (int) study.scores().stream().map(DetectionScore::participant).distinct().count();
    List<String> fewer = new ArrayList<>();
    for (AreaAnalysis column : columns) {
      int n = column.design().subjects().size();
      if (n < all && column.measure() == DetectionMeasure.D_PRIME) {
        fewer.add("%s: n = %d".formatted(column.level().heading(), n));
      }
    }
    return fewer.isEmpty()
        ? "n = %s.".formatted(Pluralizer.of(all, "participant"))
        : "Of %s, some do not have every score (%s); they are named below."
            .formatted(Pluralizer.of(all, "participant"), String.join(", ", fewer));
  }

  /** Returns the O of the thesis: how many objects of a type were present in the area. */
  private long present(String type) {
    return study.responses().usable().stream()
        .filter(response -> response.area().equals(area) && response.type().equals(type))
        .filter(Response::present)
        .map(Response::object)
        .distinct()
        .count();
  }

  private List<String> row(
      String name, String type, Optional<String> condition, TableNumberFormat figures) {
    List<String> row = new ArrayList<>(List.of(name));
    for (AreaAnalysis column : columns) {
      Optional<CellDescriptives> found = descriptive(column.design(), type, condition);
      row.add(
          found
              .map(
                  of -> figures.number(of.mean(), 2) + " (" + figures.number(of.sd(), 2, ONE) + ")")
              .orElseGet(() -> figures.dash(NONE)));
      if (closesLevel(column)) {
        row.add(String.valueOf(found.map(CellDescriptives::n).orElse(0)));
      }
    }
    return row;
  }

  /**
   * Returns whether a column is the last of its confidence level; all columns of a level have the
   * same participants.
   */
  private static boolean closesLevel(AreaAnalysis column) {
    return column.measure() == MEASURES.get(MEASURES.size() - 1);
  }

  private static Optional<CellDescriptives> descriptive(
      FactorialDesign design, String type, Optional<String> condition) {
    boolean types = design.within().varies();
    for (CellDescriptives found : CellDescriptives.of(design)) {
      boolean own = !types || found.within().equals(Optional.of(type));
      boolean group =
          found.between().equals(condition) || condition.isEmpty() && !design.between().varies();
      if (own && group && found.n() > 0) {
        return Optional.of(found);
      }
    }
    return Optional.empty();
  }
}
