/**
 * Analysis of variance of one between and one within factor, and what belongs beside a table of F:
 * effect sizes, marginal means, comparisons, equivalence, Bayes factors (thesis 6.3.2, Figs 92-98).
 *
 * <p>An analysis is four hypotheses (intercept, between, within, interaction): each is a matrix of
 * sums of squares and products of orthonormal transformations of the within levels, beside one of
 * error. Univariate F is their trace, the multivariate statistics are eigenvalues; type III sums
 * have closed forms with one between factor, so no general linear model is needed. Means,
 * comparisons, equivalence tests and the Bayes factors of comparisons are weighted sums of cell
 * means with the pooled covariance.
 *
 * <p>In: a {@link org.selectiverenderer.statistics.anova.Design}. Out: {@link
 * org.selectiverenderer.statistics.anova.Anova}, of records. What is not defined for some data is
 * not a number in a record, with the reason beside it in words; reports print the reason. Uses
 * {@code statistics.distribution}, {@code base.decimal} and Commons Math.
 */
@NullMarked
package org.selectiverenderer.statistics.anova;

import org.jspecify.annotations.NullMarked;
