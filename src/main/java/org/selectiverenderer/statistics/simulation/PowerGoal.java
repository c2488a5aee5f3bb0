package org.selectiverenderer.statistics.simulation;

import org.selectiverenderer.statistics.study.AreaStudy;

/** What a study is to find. Spelled as users type it. */
public enum PowerGoal {
  condition(AreaStudy.BETWEEN),
  type(AreaStudy.WITHIN),
  interaction(AreaStudy.WITHIN + " x " + AreaStudy.BETWEEN),
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
