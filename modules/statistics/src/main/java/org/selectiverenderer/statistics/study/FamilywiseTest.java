package org.selectiverenderer.statistics.study;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;

/**
 * A test of an effect among all tests of the study at its level of confidence. Each level of
 * confidence is a family of its own, since the levels test the same hypotheses on nested subsets of
 * the same answers.
 *
 * @param p unadjusted p of the effect
 * @param adjusted p after the {@link MultipleTestingCorrection}
 * @param size size of the family: the number of tests of all effects on all measures in all areas
 *     at this level
 */
public record FamilywiseTest(
    AreaAnalysis analysis, Effect effect, double p, double adjusted, int size) {
  /** Returns the tests that have a p, level by level, area by area, measure by measure. */
  static List<FamilywiseTest> of(
      List<AreaAnalysis> analyses, MultipleTestingCorrection correction) {
    List<FamilywiseTest> tests = new ArrayList<>();
    for (ConfidenceThreshold level : ConfidenceThreshold.values()) {
      List<FamilywiseTest> family = new ArrayList<>();
      for (AreaAnalysis analysis : analyses) {
        if (analysis.level() == level && analysis.anova().isPresent()) {
          for (Effect effect : analysis.anova().get().effects()) {
            if (Double.isFinite(effect.p())) {
              family.add(new FamilywiseTest(analysis, effect, effect.p(), effect.p(), 0));
            }
          }
        }
      }
      double[] adjusted = correction.of(family.stream().map(FamilywiseTest::p).toList());
      for (int i = 0; i < adjusted.length; i++) {
        FamilywiseTest raw = family.get(i);
        tests.add(
            new FamilywiseTest(raw.analysis(), raw.effect(), raw.p(), adjusted[i], family.size()));
      }
    }
    return tests;
  }
}
