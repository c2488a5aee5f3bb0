/**
 * Analysis of variance of one between and one within factor, and what belongs beside a table of F:
 * effect sizes, marginal means, comparisons, equivalence, Bayes factors (thesis 6.3.2, Figs 92-98).
 *
 * <p>In: a {@link org.selectiverenderer.statistics.anova.Design}. Out: {@link
 * org.selectiverenderer.statistics.anova.Anova}, of records. What is not defined for some data is
 * not a number in a record, with the reason beside it in words; reports print the reason. Uses
 * {@code statistics.distribution} and Commons Math.
 */
@NullMarked
package org.selectiverenderer.statistics.anova;

import org.jspecify.annotations.NullMarked;
