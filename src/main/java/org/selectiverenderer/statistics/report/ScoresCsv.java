package org.selectiverenderer.statistics.report;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.statistics.detection.Measure;
import org.selectiverenderer.statistics.detection.Score;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/** Scores as CSV, for other programs. What is not defined is an empty cell. */
final class ScoresCsv {
  private static final MathContext DIGITS = new MathContext(10);

  private ScoresCsv() {}

  /** One row for each participant, area, type of object and level of confidence. */
  static String tidy(StudyAnalysis study) {
    CsvText table = new CsvText();
    table.row(
        "participant",
        "condition",
        "area",
        "object_type",
        "confidence",
        "objects",
        "hits",
        "misses",
        "false_alarms",
        "correct_rejections",
        "hit_rate",
        "false_alarm_rate",
        "d_prime",
        "log_beta",
        "c",
        "note");
    for (Score score : study.scores()) {
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
      for (Measure measure : Measure.values()) {
        row.add(cell(measure.of(score.detection())));
      }
      row.add(score.detection().flaw().orElse(""));
      table.row(row);
    }
    return table.toString();
  }

  /** One row for each participant, a column for each score: what SPSS and JASP take. */
  static String wide(StudyAnalysis study) {
    Set<String> columns = new LinkedHashSet<>();
    Map<String, Map<String, String>> participants = new LinkedHashMap<>();
    for (Score score : study.scores()) {
      Map<String, String> row =
          participants.computeIfAbsent(score.participant(), id -> new LinkedHashMap<>());
      row.put("condition", score.condition());
      for (Measure measure : Measure.values()) {
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
    CsvText table = new CsvText().row(header);
    participants.forEach(
        (id, values) -> {
          List<Object> row = new ArrayList<>(List.of(id, values.getOrDefault("condition", "")));
          columns.forEach(column -> row.add(values.getOrDefault(column, "")));
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
