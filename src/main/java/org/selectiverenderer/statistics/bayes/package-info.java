/**
 * Bayes factors of the effects of an analysis of variance, by Jeffreys, Zellner and Siow (Rouder,
 * Morey, Speckman and Province 2012, Journal of Mathematical Psychology 56).
 *
 * <p>A model is a set of terms. The effects of term t have variances g_t s², each g_t has an
 * inverse gamma prior, s² and the mean of all have Jeffreys' prior, and where there are within
 * factors each participant has an effect, a term in every model.
 *
 * <p>An effect's Bayes factor is the evidence of the model of all terms that do not contain it over
 * that of the same and the effect. So no other effect is taken for error, and no model has an
 * interaction without its main effects (Rouder, Engelhardt, McCabe and Morey 2016, Psychonomic
 * Bulletin and Review 23): what sums of squares of type II compare. A second one leaves out of both
 * models what the effect does not contain. All are ratios of models that BayesFactor's anovaBF
 * prints.
 *
 * <p>The evidence is an integral over s² and all g. Orthonormal transformations of the within
 * levels take it apart: given s² and the g of the participants, the average and the contrasts of
 * each set of within factors ({@code Stratum}) are independent, and in them the terms whose columns
 * are orthogonal: all, where groups are of equal size. What hangs together is a {@code Component}.
 * Its integral over the g of one or two terms is a sum in equal steps ({@code Nodes}); of three and
 * more, which only unequal groups of two and more factors have, one of quasi-random points with a
 * seed, repeated to tell its error. Over s² and the participants' g the integrals are nested
 * ({@code Evidence}, {@code LogIntegral}).
 *
 * <p>In: a {@link org.selectiverenderer.statistics.anova.Design} and options. Out: {@link
 * org.selectiverenderer.statistics.bayes.EffectEvidence} of each effect. Uses {@code
 * statistics.anova} and Commons Math.
 */
@NullMarked
package org.selectiverenderer.statistics.bayes;

import org.jspecify.annotations.NullMarked;
