/**
 * The analyses of a study of recognition memory (thesis 6.4, 6.5): every measure of every area at
 * every level of confidence, the effects that cannot be tested, the correction for multiple
 * testing, and the confidence ratings of conditions and participants.
 *
 * <p>In: {@link org.selectiverenderer.statistics.data.Responses} and options. Out: {@link
 * org.selectiverenderer.statistics.study.StudyAnalysis}. Uses {@code statistics.data}, {@code
 * statistics.detection}, {@code statistics.anova}, {@code statistics.bayes} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.statistics.study;

import org.jspecify.annotations.NullMarked;
