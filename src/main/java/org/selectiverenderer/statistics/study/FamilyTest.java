package org.selectiverenderer.statistics.study;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.detection.ConfidenceLevel;

/**
 * A test of an effect among all tests of the study at its level of confidence. Each level of
 * confidence is a family of its own, since the levels test the same hypotheses on nested subsets of
 * the same answers.
 *
 * @param p unadjusted p of the effect
 * @param adjusted p after the {@link FamilyCorrection}
 * @param size size of the family: the number of tests of all effects on all measures in all areas
 *     at this level
 */
public record FamilyTest(
    AreaAnalysis analysis, Effect effect, double p, double adjusted, int size) {
  /** Returns the tests that have a p, level by level, area by area, measure by measure. */
  static List<FamilyTest> of(List<AreaAnalysis> analyses, FamilyCorrection correction) {
    List<FamilyTest> tests = new ArrayList<>();
    for (ConfidenceLevel level : ConfidenceLevel.values()) {
      List<FamilyTest> family = new ArrayList<>();
      for (AreaAnalysis analysis : analyses) {
        if (analysis.level() == level && analysis.anova().isPresent()) {
          for (Effect effect : analysis.anova().get().effects()) {
            if (Double.isFinite(effect.p())) {
              family.add(new FamilyTest(analysis, effect, effect.p(), effect.p(), 0));
            }
          }
        }
      }
      double[] adjusted = correction.of(family.stream().map(FamilyTest::p).toList());
      for (int i = 0; i < adjusted.length; i++) {
        FamilyTest raw = family.get(i);
        tests.add(
            new FamilyTest(raw.analysis(), raw.effect(), raw.p(), adjusted[i], family.size()));
      }
    }
    return tests;
  }
}
