/**
 * Questionnaires without a window: what is asked, in what order and words, what an answer is; also
 * on paper, and what was typed in from it.
 *
 * <p>In: the items of a study, a CSV per questionnaire; the words, a file of messages per language.
 * Out: {@link org.selectiverenderer.experiment.questionnaire.Screen}s to be answered in a window or
 * on paper, answers as rows for the statistics, ratings as rows for the enricher.
 *
 * <p>Uses {@code experiment.study}, {@code statistics.data} and {@code statistics.detection} for
 * the columns of answers, and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.questionnaire;

import org.jspecify.annotations.NullMarked;
