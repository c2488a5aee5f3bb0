package org.selectiverenderer.statistics.simulation;

import org.selectiverenderer.statistics.study.AreaAnalyser;

/** The hypothesis for which a power is sought. The constants are spelled as users type them. */
public enum TestedHypothesis {
  /** The conditions differ. */
  condition(AreaAnalyser.BETWEEN),
  /** The types of objects differ. */
  type(AreaAnalyser.WITHIN),
  /** The difference between types depends on the condition. */
  interaction(AreaAnalyser.WITHIN + " x " + AreaAnalyser.BETWEEN),
  /** The conditions are equivalent. */
  equivalence(PowerAnalysis.EQUIVALENCE);

  private final String finding;

  TestedHypothesis(String finding) {
    this.finding = finding;
  }

  /** Returns the name of its {@link PowerEstimate.Finding}. */
  public String finding() {
    return finding;
  }
}
