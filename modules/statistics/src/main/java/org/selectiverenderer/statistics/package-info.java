/**
 * Statistics of the thesis's study and of studies like it (thesis 6.3 to 6.5): from a file of
 * answers to tables with F and p.
 *
 * <p>{@code data} reads files into designs; {@code detection} computes d', log beta and c from
 * answers; {@code anova} computes the analysis of variance with effect sizes, comparisons and
 * equivalence tests, {@code bayes} the Bayes factors of effects; {@code assumption} checks the
 * assumptions of the analysis; {@code distribution} has the distributions that Commons Math lacks;
 * {@code study} runs the analyses of a study; {@code apa} formats their results for manuscripts;
 * {@code script} writes the same analyses as an R script; {@code report} writes reports; {@code
 * simulation} simulates participants of known sensitivity for power analyses. Together they use
 * {@code chart}, {@code geometry.font}, {@code base} and Commons Math; none loads AWT or GL, and
 * nothing here depends on how answers were collected: {@code study} uses {@code statistics}, never
 * the other way round.
 */
@NullMarked
package org.selectiverenderer.statistics;

import org.jspecify.annotations.NullMarked;
