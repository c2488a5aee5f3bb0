package org.selectiverenderer.experiment.study;

import java.util.Locale;

/** The questionnaires of the thesis. */
public enum QuestionKind {
  /** Was the object there? Yes or no, and how sure, 1 to 5 (thesis Appendix D, Fig 86). */
  RECOGNITION,
  /** How likely is the object in such a place? 1 to 6 (thesis Appendix A, Fig 54). */
  EXPECTANCY;

  /** As the study file spells it. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }
}
