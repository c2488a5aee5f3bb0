/**
 * Analysis of variance of any number of between and within factors and covariates, and what belongs
 * beside a table of F: effect sizes, marginal means, comparisons, equivalence (thesis 6.3.2, Figs
 * 92-98).
 *
 * <p>A {@link org.selectiverenderer.statistics.anova.Design} makes one multivariate linear model: a
 * row of scores for each subject, explained by its group and covariates ({@code CellStatistics}).
 * An effect ({@link org.selectiverenderer.statistics.anova.Term}) is a hypothesis about its
 * coefficients, L B M = 0: L compares groups, M within levels. It leaves a matrix of sums of
 * squares and products of its own and one of error ({@code Hypothesis}); univariate F is their
 * traces', the multivariate statistics are eigenvalues. Where sphericity is lacking, degrees of
 * freedom are multiplied by epsilon, and everything that rests on them follows ({@link
 * org.selectiverenderer.statistics.anova.CorrectedDf}). Means, comparisons and equivalence tests
 * are weighted sums of the coefficients with the pooled covariance.
 *
 * <p>In: a design. Out: {@link org.selectiverenderer.statistics.anova.Anova}, of records. What is
 * not defined for some data is not a number in a record, with the reason beside it in words;
 * reports print the reason. Uses {@code statistics.distribution}, {@code base.decimal} and Commons
 * Math.
 */
@NullMarked
package org.selectiverenderer.statistics.anova;

import org.jspecify.annotations.NullMarked;
