package org.selectiverenderer.study.definition;

import java.util.Locale;

/** How participants are assigned to conditions. Both methods keep the groups balanced. */
public enum ConditionAssignment {
  /** Permuted blocks: each block contains each condition equally often, in a random order. */
  BLOCKED,
  /**
   * Latin squares: each block contains each condition once, and in as many blocks as there are
   * conditions each condition is at each place of a block once. So no condition is tested first, or
   * last, more often than another.
   */
  LATIN_SQUARE;

  /** Returns the spelling in a study file. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
