/**
 * Questionnaires on paper: a page to print, the data-entry table for its answers, and the reader of
 * filled-in tables.
 *
 * <p>In: questionnaires in a participant's order of questions; tables. Out: HTML, CSV, and answers
 * by participant and questionnaire, or the faults of a table by line and column. Depends on {@link
 * org.selectiverenderer.study.questionnaire.AnswerField}s, not on kinds of questions.
 *
 * <p>Uses {@code study.questionnaire} and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.study.questionnaire.paper;

import org.jspecify.annotations.NullMarked;
