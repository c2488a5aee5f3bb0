package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.statistics.apa.ApaSentences;
import org.selectiverenderer.statistics.apa.ApaTable;
import org.selectiverenderer.statistics.apa.ApaTables;
import org.selectiverenderer.statistics.apa.MethodsParagraph;
import org.selectiverenderer.statistics.detection.ConfidenceLevel;
import org.selectiverenderer.statistics.study.RatingScore;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Writes parts of a study's report as files for a manuscript; maps file names without a folder to
 * their texts.
 */
public final class StudyFiles {
  private StudyFiles() {}

  /** Returns each plot as SVG: {@code AREA-MEASURE-LEVEL.svg} and {@code AREA-TYPE-roc.svg}. */
  public static Map<String, String> figures(StudyAnalysis study) {
    Map<String, String> files = new LinkedHashMap<>();
    FileStems stems = new FileStems();
    MeansPlot means = new MeansPlot();
    RocPlot roc = new RocPlot();
    for (String area : study.areas()) {
      study
          .analyses(area)
          .forEach(
              analysis ->
                  analysis
                      .anova()
                      .ifPresent(
                          anova ->
                              files.put(
                                  "%s-%s-%s.svg"
                                      .formatted(
                                          stems.of(area),
                                          analysis.measure().key(),
                                          level(analysis.level())),
                                  means.file(anova, StudyBlocks.title(analysis)))));
      List<RatingScore> pooled = study.ratings(area, true);
      for (String type : pooled.stream().map(RatingScore::type).distinct().toList()) {
        files.put(
            "%s-%s-roc.svg".formatted(stems.of(area), type),
            roc.file(
                pooled.stream().filter(score -> score.type().equals(type)).toList(),
                RatingBlocks.title(area, type)));
      }
    }
    return files;
  }

  private static String level(ConfidenceLevel level) {
    return switch (level) {
      case ALL -> "all";
      case MODERATE -> "confidence-3-5";
      case HIGH -> "confidence-5";
    };
  }

  /**
   * Returns each table as {@code AREA-NAME.html}, {@code .tex} and {@code .csv}; also {@code
   * sentences.txt} and {@code methods.txt}.
   */
  public static Map<String, String> tables(StudyAnalysis study, Provenance provenance) {
    Map<String, String> files = new LinkedHashMap<>();
    FileStems stems = new FileStems();
    List<String> sentences = new ArrayList<>();
    for (String area : study.areas()) {
      for (ApaTable table : ApaTables.of(study, area)) {
        String name = stems.of(area) + "-" + table.name();
        files.put(name + ".html", table.html());
        files.put(name + ".tex", table.latex());
        files.put(name + ".csv", table.csv());
      }
      for (ConfidenceLevel level : ConfidenceLevel.values()) {
        sentences.addAll(ApaSentences.of(study, area, level));
      }
    }
    String origin = provenance.head(study.responses().source()).text();
    files.put("sentences.txt", origin + "\n\n" + String.join("\n", sentences) + "\n");
    MethodsParagraph methods = new MethodsParagraph(study, provenance.maker());
    files.put(
        "methods.txt",
        methods.text()
            + "\n\nReferences\n\n"
            + String.join("\n", methods.references())
            + "\n\n"
            + origin
            + "\n");
    return files;
  }
}
