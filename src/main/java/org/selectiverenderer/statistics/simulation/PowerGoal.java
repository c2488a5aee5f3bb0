package org.selectiverenderer.statistics.simulation;

import org.selectiverenderer.statistics.study.AreaStudy;

/** What a study is to find. Spelled as users type it. */
public enum PowerGoal {
  /** That the conditions differ. */
  condition(AreaStudy.BETWEEN),
  /** That the types of objects differ. */
  type(AreaStudy.WITHIN),
  /** That the types differ by other amounts in other conditions. */
  interaction(AreaStudy.WITHIN + " x " + AreaStudy.BETWEEN),
  /** That the conditions are equivalent. */
  equivalence(PowerAnalysis.EQUIVALENCE);

  private final String finding;

  PowerGoal(String finding) {
    this.finding = finding;
  }

  /** The name of its {@link Power.Finding}. */
  public String finding() {
    return finding;
  }
}
