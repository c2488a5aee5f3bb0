package org.selectiverenderer.statistics.report;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScore;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/** Writes scores as CSV for other programs. A value that is not defined is an empty cell. */
final class ScoresCsvWriter {
  private static final MathContext DIGITS = new MathContext(10);

  private ScoresCsvWriter() {}

  /**
   * Returns the tidy (long) table: one row for each participant, area, type of object and level of
   * confidence.
   */
  static String tidy(StudyAnalysis study, Provenance provenance) {
    CsvWriter table = new CsvWriter();
    List<Object> header = new ArrayList<>();
    header.addAll(List.of("participant", "condition", "area", "object_type", "confidence"));
    header.addAll(List.of("objects", "hits", "misses", "false_alarms", "correct_rejections"));
    header.addAll(List.of("hit_rate", "false_alarm_rate", "d_prime", "log_beta", "c", "note"));
    header.addAll(List.of("a_prime", "b_double_prime"));
    Map<String, String> origin = provenance.cells(study.responses().source());
    header.addAll(origin.keySet());
    table.row(header);
    for (DetectionScore score : study.scores()) {
      List<Object> row = new ArrayList<>();
      row.addAll(List.of(score.participant(), score.condition(), score.area(), score.type()));
      row.add(score.level().spelling());
      row.add(score.objects());
      row.add(score.counts().hits());
      row.add(score.counts().misses());
      row.add(score.counts().falseAlarms());
      row.add(score.counts().correctRejections());
      row.add(cell(score.detection().hitRate()));
      row.add(cell(score.detection().falseAlarmRate()));
      for (DetectionMeasure measure : DetectionMeasure.values()) {
        row.add(cell(measure.of(score.detection())));
      }
      row.add(score.detection().flaw().orElse(""));
      row.add(cell(score.detection().aPrime()));
      row.add(cell(score.detection().bDoublePrime()));
      row.addAll(origin.values());
      table.row(row);
    }
    return table.toString();
  }

  /**
   * Returns the wide table that SPSS and JASP read: one row for each participant, a column for each
   * score.
   */
  static String wide(StudyAnalysis study, Provenance provenance) {
    Set<String> columns = new LinkedHashSet<>();
    Map<String, Map<String, String>> participants = new LinkedHashMap<>();
    for (DetectionScore score : study.scores()) {
      Map<String, String> row =
          participants.computeIfAbsent(score.participant(), id -> new LinkedHashMap<>());
      row.put("condition", score.condition());
      for (DetectionMeasure measure : DetectionMeasure.values()) {
        String level =
            switch (score.level()) {
              case ALL -> "all";
              case MODERATE -> "3to5";
              case HIGH -> "5";
            };
        String column =
            String.join("_", score.area(), score.type(), measure.key(), level).replace(' ', '_');
        columns.add(column);
        row.put(column, cell(measure.of(score.detection())));
      }
    }
    List<Object> header = new ArrayList<>(List.of("participant", "condition"));
    header.addAll(columns);
    Map<String, String> origin = provenance.cells(study.responses().source());
    header.addAll(origin.keySet());
    CsvWriter table = new CsvWriter().row(header);
    participants.forEach(
        (id, values) -> {
          List<Object> row = new ArrayList<>(List.of(id, values.getOrDefault("condition", "")));
          columns.forEach(column -> row.add(values.getOrDefault(column, "")));
          row.addAll(origin.values());
          table.row(row);
        });
    return table.toString();
  }

  private static String cell(double value) {
    return Double.isFinite(value)
        ? new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString()
        : "";
  }
}
