package org.selectiverenderer.statistics.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.Response;
import org.selectiverenderer.statistics.report.ReportBlock.Table;
import org.selectiverenderer.statistics.study.AreaAnalyser;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.statistics.study.MultipleTestingCorrection;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Tables 6 to 11 of the thesis: scores of 18 participants in each condition with exactly the
 * printed means and standard deviations come out as the printed tables, cell by cell.
 */
class MemoryTablesTest {
  private static final Path GOLDEN =
      Path.of(
          "modules/statistics/src/test/resources/org/selectiverenderer/statistics/report/tables-6-11.txt");
  private static final List<String> CONDITIONS = List.of("high", "high-low", "selective");
  private static final List<String> AREAS =
      List.of("kitchen", "office", "desk", "bookcase", "lounge", "sofa");
  private static final int GROUP = 18;

  /** Totals that are farther from those of the printed rows than rounding brings them. */
  private static final List<String> MISPRINTED_MEANS =
      List.of("desk consistent b_un", "desk consistent d_mod");

  private static final List<String> MISPRINTED_DEVIATIONS =
      List.of("desk consistent b_un", "lounge all d_un");

  private final Map<String, CSVRecord> printed = new LinkedHashMap<>();

  MemoryTablesTest() throws IOException {
    try (InputStream in =
            Objects.requireNonNull(getClass().getResourceAsStream("tables-6-11.csv"));
        var text = new InputStreamReader(in, StandardCharsets.UTF_8)) {
      CSVFormat.DEFAULT.builder().setHeader().setSkipHeaderRecord(true).get().parse(text).stream()
          .forEach(
              row ->
                  printed.put(
                      row.get("area") + ' ' + row.get("objects") + ' ' + row.get("condition"),
                      row));
    }
  }

  @Test
  void theLayoutIsThatOfTheThesis() throws IOException {
    List<ReportBlock> tables = new ArrayList<>();
    AREAS.forEach(area -> tables.add(ScoresTable.of(study(area), area)));
    String text = TextReportWriter.of("Tables 6 to 11", tables, true);
    if (Boolean.getBoolean("reports.update")) {
      Files.writeString(GOLDEN, text);
    }
    assertThat(text).isEqualTo(Files.readString(GOLDEN).replace("\r\n", "\n"));
  }

  @Test
  void everyCellIsThePrintedOne() {
    List<String> means = new ArrayList<>();
    List<String> deviations = new ArrayList<>();
    int cells = 0;
    for (String area : AREAS) {
      Table table = ScoresTable.of(study(area), area);
      String objects = "";
      for (List<String> row : table.rows()) {
        if (row.size() == 1) {
          objects = objects(row.get(0).substring(0, row.get(0).indexOf(' ')));
          assertThat(row.get(0)).endsWith("(O = " + printed(area, objects, "high").get("O") + ")");
          continue;
        }
        CSVRecord own = printed(area, objects, row.get(0));
        int scores = 0;
        for (int column = 1; column < row.size(); column++) {
          if (table.header().get(column).equals("n")) {
            assertThat(row.get(column)).isEqualTo(row.get(0).equals("total") ? "54" : "18");
            continue;
          }
          cells++;
          String name = column(scores++);
          String cell = row.get(column).replace('\u2212', '-');
          if (!row.get(0).equals("total")) {
            assertThat(cell).isEqualTo(own.get(name) + " (" + own.get(name + "_sd") + ")");
            continue;
          }
          String[] found = cell.replace(")", "").split(" \\(");
          String what = area + ' ' + objects + ' ' + name;
          if (differs(found[0], own.get(name))) {
            means.add(what);
          }
          if (differs(found[1], own.get(name + "_sd"))) {
            deviations.add(what);
          }
        }
      }
    }
    assertThat(cells).isEqualTo(9 * 4 * 6);
    assertThat(means).containsExactlyElementsOf(MISPRINTED_MEANS);
    assertThat(deviations).containsExactlyElementsOf(MISPRINTED_DEVIATIONS);
  }

  /** By more than the printed rows were rounded. */
  private static boolean differs(String ours, String theirs) {
    return Math.abs(Double.parseDouble(ours) - Double.parseDouble(theirs)) > 0.0101;
  }

  private static String objects(String type) {
    return type.equals("neutral") ? "all" : type;
  }

  /** The thesis calls all answers uncorrected, and the levels of confidence moderate and high. */
  private static String column(int index) {
    return (index % 2 == 0 ? "d_" : "b_") + List.of("un", "mod", "high").get(index / 2);
  }

  private CSVRecord printed(String area, String objects, String condition) {
    return Objects.requireNonNull(printed.get(area + ' ' + objects + ' ' + condition));
  }

  private StudyAnalysis study(String area) {
    List<String> types =
        Response.TYPES.stream()
            .filter(type -> printed.containsKey(area + ' ' + objects(type) + " high"))
            .toList();
    List<AreaAnalysis> analyses = new ArrayList<>();
    for (ConfidenceThreshold level : ConfidenceThreshold.values()) {
      for (DetectionMeasure measure :
          List.of(DetectionMeasure.D_PRIME, DetectionMeasure.LOG_BETA)) {
        String column = column(2 * level.ordinal() + (measure == DetectionMeasure.D_PRIME ? 0 : 1));
        analyses.add(
            new AreaAnalysis(
                area, level, measure, design(area, types, column), Optional.empty(), List.of()));
      }
    }
    List<Response> answers = answers(area, types);
    return new StudyAnalysis(
        new Responses(DataSource.none("thesis"), answers, List.of()),
        DetectionScorer.DEFAULT,
        AnovaOptions.DEFAULT,
        CONDITIONS,
        List.of(area),
        DetectionScorer.DEFAULT.scores(answers),
        analyses,
        MultipleTestingCorrection.NONE,
        List.of(),
        List.of());
  }

  private FactorialDesign design(String area, List<String> types, String column) {
    List<Subject> subjects = new ArrayList<>();
    for (int group = 0; group < CONDITIONS.size(); group++) {
      for (int i = 0; i < GROUP; i++) {
        // Evenly spread numbers of mean 0 and standard deviation 1.
        double z = (i - (GROUP - 1) / 2.0) / Math.sqrt(GROUP * (GROUP + 1) / 12.0);
        String condition = CONDITIONS.get(group);
        List<Double> values =
            types.stream()
                .map(type -> printed(area, objects(type), condition))
                .map(
                    row ->
                        Double.parseDouble(row.get(column))
                            + z * Double.parseDouble(row.get(column + "_sd")))
                .toList();
        subjects.add(new Subject(condition + i, group, values));
      }
    }
    return new FactorialDesign(
        column,
        new Factor(AreaAnalyser.WITHIN, types),
        new Factor(AreaAnalyser.BETWEEN, CONDITIONS),
        subjects);
  }

  /** Everybody is asked for the O present objects and as many absent ones. */
  private List<Response> answers(String area, List<String> types) {
    List<Response> answers = new ArrayList<>();
    for (int i = 0; i < CONDITIONS.size() * GROUP; i++) {
      String participant = CONDITIONS.get(i / GROUP) + i % GROUP;
      String condition = CONDITIONS.get(i / GROUP);
      for (String type : types) {
        int present = Integer.parseInt(printed(area, objects(type), condition).get("O"));
        IntStream.range(0, 2 * present)
            .mapToObj(
                object ->
                    new Response(
                        participant,
                        condition,
                        area,
                        type + object,
                        type,
                        object < present,
                        true,
                        5,
                        SourceLocation.of("thesis")))
            .forEach(answers::add);
      }
    }
    return answers;
  }
}
