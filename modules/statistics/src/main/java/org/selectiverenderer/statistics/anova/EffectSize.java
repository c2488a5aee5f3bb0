package org.selectiverenderer.statistics.anova;

/**
 * An effect size with its confidence interval; bounds that are not defined are NaN.
 *
 * @param confidence confidence level of the interval, 0 to 1
 */
public record EffectSize(double value, double low, double high, double confidence) {}
