package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.statistics.apa.ApaSentences;
import org.selectiverenderer.statistics.apa.ApaTable;
import org.selectiverenderer.statistics.apa.ApaTableBuilder;
import org.selectiverenderer.statistics.apa.MethodsParagraph;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.study.RatingAnalysis;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Writes parts of a study's report as files for a manuscript; maps file names without a folder to
 * their texts.
 */
public final class ManuscriptFiles {
  private ManuscriptFiles() {}

  /** Returns each plot as SVG: {@code AREA-MEASURE-LEVEL.svg} and {@code AREA-TYPE-roc.svg}. */
  public static Map<String, String> figures(StudyAnalysis study) {
    Map<String, String> files = new LinkedHashMap<>();
    UniqueFileStems stems = new UniqueFileStems();
    InteractionPlot means = new InteractionPlot();
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
                                  means.file(anova, StudyReportBuilder.title(analysis)))));
      List<RatingAnalysis> pooled = study.ratings(area, true);
      for (String type : pooled.stream().map(RatingAnalysis::type).distinct().toList()) {
        files.put(
            "%s-%s-roc.svg".formatted(stems.of(area), type),
            roc.file(
                pooled.stream().filter(score -> score.type().equals(type)).toList(),
                RatingSection.title(area, type)));
      }
    }
    return files;
  }

  private static String level(ConfidenceThreshold level) {
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
    UniqueFileStems stems = new UniqueFileStems();
    List<String> sentences = new ArrayList<>();
    for (String area : study.areas()) {
      for (ApaTable table : ApaTableBuilder.of(study, area)) {
        String name = stems.of(area) + "-" + table.name();
        files.put(name + ".html", table.html());
        files.put(name + ".tex", table.latex());
        files.put(name + ".csv", table.csv());
      }
      for (ConfidenceThreshold level : ConfidenceThreshold.values()) {
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

  /**
   * Makes file name stems from names of areas, which may contain any character: letters and digits
   * stay, all else becomes a hyphen. Two areas never share a stem, even on file systems that ignore
   * case.
   */
  private static final class UniqueFileStems {
    private final Map<String, String> stems = new HashMap<>();
    private final Set<String> taken = new HashSet<>();

    /** Returns the stem of a name, always the same for the same name. */
    String of(String name) {
      return stems.computeIfAbsent(name, this::free);
    }

    private String free(String name) {
      String plain =
          name.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N}]+", "-").replaceAll("^-|-$", "");
      String stem = plain.isEmpty() ? "area" : plain;
      String free = stem;
      for (int i = 2; !taken.add(free); i++) {
        free = stem + "-" + i;
      }
      return free;
    }
  }
}
