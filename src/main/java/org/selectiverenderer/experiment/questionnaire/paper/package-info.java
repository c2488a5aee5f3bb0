/**
 * Questionnaires on paper: a page to print, the table that goes with it, and what was typed into
 * such tables.
 *
 * <p>In: questionnaires as a participant meets them; tables. Out: HTML, CSV, and answers by
 * participant and questionnaire, or what is wrong with the table, by line and column. Knows {@link
 * org.selectiverenderer.experiment.questionnaire.AnswerField}s, and no kinds of questions.
 *
 * <p>Uses {@code experiment.questionnaire} and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.questionnaire.paper;

import org.jspecify.annotations.NullMarked;
