package org.selectiverenderer.experiment.study;

import java.util.Locale;

/** How participants come to their conditions. Both keep the groups balanced. */
public enum Assignment {
  /** Blocks that hold each condition equally often, each in an order of its own drawn by lot. */
  BLOCKED,
  /**
   * Blocks that hold each condition once; of as many blocks as conditions, each condition is at
   * each place of a block once. So none is tested first, or last, more often than another.
   */
  LATIN_SQUARE;

  /** As a study file writes it. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
