package org.selectiverenderer.statistics.simulation;

import org.selectiverenderer.statistics.study.AreaStudy;

/** The hypothesis for which a power is sought. The constants are spelled as users type them. */
public enum PowerGoal {
  /** The conditions differ. */
  condition(AreaStudy.BETWEEN),
  /** The types of objects differ. */
  type(AreaStudy.WITHIN),
  /** The difference between types depends on the condition. */
  interaction(AreaStudy.WITHIN + " x " + AreaStudy.BETWEEN),
  /** The conditions are equivalent. */
  equivalence(PowerAnalysis.EQUIVALENCE);

  private final String finding;

  PowerGoal(String finding) {
    this.finding = finding;
  }

  /** Returns the name of its {@link Power.Finding}. */
  public String finding() {
    return finding;
  }
}
