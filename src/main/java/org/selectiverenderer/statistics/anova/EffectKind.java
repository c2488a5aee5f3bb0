package org.selectiverenderer.statistics.anova;

/** The sorts of effects. */
public enum EffectKind {
  /** That the mean of all is not 0. */
  INTERCEPT,
  /** Of between factors. */
  BETWEEN,
  /** Of within factors. */
  WITHIN,
  /** Of both on each other. */
  INTERACTION,
  /** Of a covariate, alone or on the effect of within factors. */
  COVARIATE
}
