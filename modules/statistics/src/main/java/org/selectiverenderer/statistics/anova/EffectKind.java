package org.selectiverenderer.statistics.anova;

/** The kinds of effects in an analysis of variance. */
public enum EffectKind {
  /** The difference of the grand mean from 0. */
  INTERCEPT,
  /** An effect of between factors. */
  BETWEEN,
  /** An effect of within factors. */
  WITHIN,
  /** An interaction of between and within factors. */
  INTERACTION,
  /** An effect of a covariate, alone or in interaction with within factors. */
  COVARIATE
}
