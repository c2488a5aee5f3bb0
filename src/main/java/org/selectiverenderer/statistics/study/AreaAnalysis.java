package org.selectiverenderer.statistics.study;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Design;
import org.selectiverenderer.statistics.bayes.BayesianAnova;
import org.selectiverenderer.statistics.detection.ConfidenceLevel;
import org.selectiverenderer.statistics.detection.Measure;

/**
 * One measure of one area at one level of confidence.
 *
 * @param design of the participants whose measure is defined for every type of object
 * @param anova empty when the design cannot be analysed; the notes say why
 * @param evidence for the null hypotheses of the anova
 * @param notes who is left out and what is not tested: sentences
 */
public record AreaAnalysis(
    String area,
    ConfidenceLevel level,
    Measure measure,
    Design design,
    Optional<Anova> anova,
    Optional<BayesianAnova> evidence,
    List<String> notes) {
  /** Keeps copies, so that it stays as it is. */
  public AreaAnalysis {
    notes = List.copyOf(notes);
  }

  /** With what the data say for the null hypotheses, computed when it is asked for. */
  public AreaAnalysis(
      String area,
      ConfidenceLevel level,
      Measure measure,
      Design design,
      Optional<Anova> anova,
      List<String> notes) {
    this(area, level, measure, design, anova, anova.map(BayesianAnova::new), notes);
  }
}
