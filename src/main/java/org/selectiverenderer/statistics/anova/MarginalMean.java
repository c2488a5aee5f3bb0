package org.selectiverenderer.statistics.anova;

import java.util.Optional;

/**
 * An estimated marginal mean: of a cell, or of a level with equal weight for each level of the
 * other factor (Searle, Speed and Milliken 1980, The American Statistician 34). Its error is the
 * pooled one, as in SPSS.
 *
 * @param within empty: all levels
 * @param between empty: all groups
 * @param df of the error
 */
public record MarginalMean(
    Optional<String> within,
    Optional<String> between,
    double mean,
    double standardError,
    double df,
    double low,
    double high) {}
