/**
 * Statistics of the thesis's study and of studies like it (thesis 6.3 to 6.5): from a file of
 * answers to tables with F and p.
 *
 * <p>{@code data} reads files into designs; {@code detection} makes d', log beta and c of answers;
 * {@code anova} tests effects and everything beside them, {@code bayes} weighs the evidence for
 * them, {@code assumption} checks what they take for granted; {@code distribution} holds what
 * Commons Math lacks; {@code study} runs the analyses of a study; {@code apa} has their results for
 * manuscripts and {@code script} for R; {@code report} writes them; {@code simulation} makes
 * participants of known sensitivity. Each names its own rules. Together they use {@code chart},
 * {@code geometry.font}, {@code base} and Commons Math; none loads AWT or GL, and nothing here
 * depends on how answers came about: the experiment uses it, never the other way round.
 */
@NullMarked
package org.selectiverenderer.statistics;

import org.jspecify.annotations.NullMarked;
