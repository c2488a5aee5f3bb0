/**
 * What is asked of a participant, without a window: questionnaires, the kinds of their questions,
 * answers, tables of answers and scores.
 *
 * <p>A {@link org.selectiverenderer.experiment.questionnaire.Questionnaire} is answered in one step
 * of a session, page by page. A page has questions, or only something to read; pages and questions
 * may depend on earlier answers. Form and consent are a questionnaire, too.
 *
 * <p>What a question is like is its {@link
 * org.selectiverenderer.experiment.questionnaire.QuestionKind}, a sealed type with one class for
 * each kind: how a file names it and which keys it has there, what there is to fill in, how a
 * simulated participant answers, in which table its answers go. What there is to fill in is told as
 * {@link org.selectiverenderer.experiment.questionnaire.AnswerField}s, of which there are two
 * sorts: options to choose from, and a line to write on. Windows, paper and what was typed in from
 * it know the fields and no kinds; so a new kind changes none of them.
 *
 * <p>Where a participant is in a questionnaire is {@link
 * org.selectiverenderer.experiment.questionnaire.QuestionnaireCourse}, whatever shows it; {@link
 * org.selectiverenderer.experiment.questionnaire.ButtonCourse} answers it by two buttons and a
 * stick.
 *
 * <p>{@code questionnaire.read} makes questionnaires of files; {@code questionnaire.paper} prints
 * them and reads what was typed in.
 *
 * <p>In: texts in the study's language, the words of the program itself ({@link
 * org.selectiverenderer.experiment.questionnaire.Wording}), answers. Out: what is to be asked next,
 * and {@code responses.csv}, {@code ratings.csv}, {@code answers.csv} and {@code scores.csv} as
 * rows. All values are immutable, the two courses are not.
 *
 * <p>Uses {@code statistics.data} and {@code statistics.detection} for the columns of answers about
 * memory, and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.questionnaire;

import org.jspecify.annotations.NullMarked;
