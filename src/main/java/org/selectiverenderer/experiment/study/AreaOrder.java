package org.selectiverenderer.experiment.study;

import java.util.Locale;

/** In which order a participant sees the areas. */
public enum AreaOrder {
  /** Everybody in that of the study file. */
  FIXED,
  /**
   * By a square balanced for what comes before what, in the order in which participants of a
   * condition come: each area is first, second, ... equally often in each group.
   */
  COUNTERBALANCED,
  /** Each participant in an order of his own, drawn by lot. */
  RANDOM;

  /** As a study file writes it. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }
}
