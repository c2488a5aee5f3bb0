/**
 * Analysis of variance with any number of between and within factors and covariates, with effect
 * sizes, marginal means, comparisons and equivalence tests (thesis 6.3.2, Figs 92-98).
 *
 * <p>A {@link org.selectiverenderer.statistics.anova.FactorialDesign} gives one multivariate linear
 * model: a row of scores for each subject, explained by its group and covariates ({@code
 * MultivariateLinearModel}). An effect ({@link org.selectiverenderer.statistics.anova.Term}) is a
 * hypothesis about its coefficients, L B M = 0: L compares groups, M within levels. It has a matrix
 * of sums of squares and cross products of the effect and one of the error ({@code
 * LinearHypothesis}); the univariate F is the ratio of their traces, the multivariate statistics
 * are functions of their eigenvalues. Where sphericity is violated, degrees of freedom are
 * multiplied by epsilon, and so are those of all that depends on them ({@link
 * org.selectiverenderer.statistics.anova.CorrectedDegreesOfFreedom}). Means, comparisons and
 * equivalence tests are weighted sums of the coefficients with the pooled covariance.
 *
 * <p>In: a design. Out: {@link org.selectiverenderer.statistics.anova.Anova}. A value that is not
 * defined for some data is NaN, with the reason in words beside it; reports print the reason. Uses
 * {@code statistics.distribution}, {@code base.decimal} and Commons Math.
 */
@NullMarked
package org.selectiverenderer.statistics.anova;

import org.jspecify.annotations.NullMarked;
