/**
 * Bayes factors of the effects of an analysis of variance with the prior of Jeffreys, Zellner and
 * Siow (Rouder, Morey, Speckman and Province 2012, Journal of Mathematical Psychology 56).
 *
 * <p>A model is a set of terms. The effects of term t have variances g_t s², each g_t has an
 * inverse gamma prior, s² and the grand mean have Jeffreys' prior, and where there are within
 * factors, participants are a random factor in every model.
 *
 * <p>An effect's Bayes factor is the evidence of the model of all terms that do not contain it over
 * that of the same and the effect. So no other effect counts as error, and no model has an
 * interaction without its main effects (Rouder, Engelhardt, McCabe and Morey 2016, Psychonomic
 * Bulletin and Review 23): it is the comparison of type II sums of squares. A second Bayes factor
 * leaves out of both models the effects that the tested one does not contain. All are ratios of
 * models that anovaBF of the R package BayesFactor prints.
 *
 * <p>The evidence is an integral over s² and all g. Orthonormal transformations of the within
 * levels factorise it: given s² and the g of the participants, the average and the contrasts of
 * each set of within factors ({@code ErrorStratum}) are independent, and so are, within each
 * stratum, terms whose columns are orthogonal (all of them where groups are of equal size). Terms
 * that are not orthogonal form a {@code NonorthogonalTermBlock}. Its integral over the g of one or
 * two terms is a sum over an equally spaced grid ({@code QuadratureGrid}); for three or more terms,
 * which occur only with two or more factors and groups of unequal size, it is importance sampling
 * with seeded quasi-random points ({@code ImportanceSampler}), in batches that estimate its error.
 * The integrals over s² and the participants' g are nested ({@code ModelEvidence}, {@code
 * LogIntegrator}).
 *
 * <p>In: a {@link org.selectiverenderer.statistics.anova.FactorialDesign} and options. Out: {@link
 * org.selectiverenderer.statistics.bayes.EffectBayesFactors} of each effect. Uses {@code
 * statistics.anova} and Commons Math.
 */
@NullMarked
package org.selectiverenderer.statistics.bayes;

import org.jspecify.annotations.NullMarked;
