/**
 * Questionnaires without a window: what is asked, in what order and words, what an answer is.
 *
 * <p>In: the items of a study, a CSV per questionnaire; the words, a file of messages per language.
 * Out: {@link org.selectiverenderer.experiment.questionnaire.Screen}s to be answered in a window or
 * on paper, answers as rows for the statistics, ratings as rows for the enricher.
 *
 * <p>May use {@code experiment.study}, {@code csv}, {@code schema} for the bands of ratings, {@code
 * statistics.data} for the columns of answers, {@code x3d} for problems. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.questionnaire;

import org.jspecify.annotations.NullMarked;
