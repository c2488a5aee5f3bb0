package org.selectiverenderer.statistics.study;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.bayes.BayesianAnova;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;

/**
 * The analysis of one measure of one area at one level of confidence.
 *
 * @param design the design of the participants whose measure is defined for every type of object
 * @param anova empty when the design cannot be analysed; the notes say why
 * @param evidence Bayes factors of the effects of the analysis of variance
 * @param notes sentences about who is left out and what is not tested
 */
public record AreaAnalysis(
    String area,
    ConfidenceThreshold level,
    DetectionMeasure measure,
    FactorialDesign design,
    Optional<Anova> anova,
    Optional<BayesianAnova> evidence,
    List<String> notes) {
  /** Makes defensive copies, so that the record is immutable. */
  public AreaAnalysis {
    notes = List.copyOf(notes);
  }

  /** Creates an analysis with Bayes factors that are computed on first use. */
  public AreaAnalysis(
      String area,
      ConfidenceThreshold level,
      DetectionMeasure measure,
      FactorialDesign design,
      Optional<Anova> anova,
      List<String> notes) {
    this(area, level, measure, design, anova, anova.map(BayesianAnova::new), notes);
  }
}
