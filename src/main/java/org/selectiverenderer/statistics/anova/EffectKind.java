package org.selectiverenderer.statistics.anova;

/** The effects of a design with one between and one within factor. */
public enum EffectKind {
  /** That the mean of all is not 0. */
  INTERCEPT,
  /** Of the between factor. */
  BETWEEN,
  /** Of the within factor. */
  WITHIN,
  /** Of both on each other. */
  INTERACTION;

  /** Whether the within levels' contrasts are tested, else their average. */
  boolean ofContrasts() {
    return this == WITHIN || this == INTERACTION;
  }

  /** Whether groups are compared with each other, else their common mean with 0. */
  boolean ofGroups() {
    return this == BETWEEN || this == INTERACTION;
  }
}
