package org.selectiverenderer.study.definition;

import java.util.Locale;

/** The order in which a participant sees the areas. */
public enum AreaOrder {
  /** The order of the study file, for all participants. */
  FIXED,
  /**
   * Counterbalanced by the rows of a balanced Latin square (Williams), in the order in which the
   * participants of a condition come: each area is first, second, ... equally often in each group.
   */
  COUNTERBALANCED,
  /** A random order for each participant. */
  RANDOM;

  /** Returns the spelling in a study file. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }
}
