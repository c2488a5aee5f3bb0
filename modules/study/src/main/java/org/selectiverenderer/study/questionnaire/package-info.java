/**
 * The model of questionnaires, without a user interface: pages, kinds of questions, answers, tables
 * of answers and scores.
 *
 * <p>A {@link org.selectiverenderer.study.questionnaire.Questionnaire} is answered in one step of a
 * session, page by page. A page has questions, or only a text to read; pages and questions may
 * depend on earlier answers (skip logic). The consent form is a questionnaire, too.
 *
 * <p>The kind of a question is a {@link org.selectiverenderer.study.questionnaire.QuestionKind}, a
 * sealed type with one class for each kind, which defines its keys in files, its input fields,
 * simulated answers and the table of the answers. Input fields are {@link
 * org.selectiverenderer.study.questionnaire.AnswerField}s, of which there are four sorts: a choice
 * of options, a line to write on, a slider, and options to be put in order. Windows, paper forms
 * and data entry depend on fields only, so that a new kind changes none of them. A grid is read as
 * one question for each of its rows.
 *
 * <p>{@link org.selectiverenderer.study.questionnaire.QuestionnaireProgress} is the participant's
 * progress in a questionnaire, in a window or in a headset; {@link
 * org.selectiverenderer.study.questionnaire.ButtonQuestionnaireController} lets the participant
 * answer with two buttons and a stick.
 *
 * <p>{@code questionnaire.read} reads questionnaires from files; {@code questionnaire.paper} prints
 * them and reads the tables into which answers on paper were typed.
 *
 * <p>In: texts in the study's language, the program's own messages ({@link
 * org.selectiverenderer.study.questionnaire.ParticipantMessages}), answers. Out: the questions to
 * ask next, and the rows of {@code responses.csv}, {@code ratings.csv}, {@code answers.csv} and
 * {@code scores.csv}. Only the two classes of a participant's progress are mutable.
 *
 * <p>Uses {@code statistics.data} and {@code statistics.detection} for the columns of answers to
 * recognition lists, and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.study.questionnaire;

import org.jspecify.annotations.NullMarked;
