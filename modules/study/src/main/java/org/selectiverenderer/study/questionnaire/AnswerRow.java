package org.selectiverenderer.study.questionnaire;

/**
 * A row of a table of answers.
 *
 * @param page the page of the question
 * @param given the answer; {@link TimedAnswer#NONE} for none
 */
public record AnswerRow(QuestionnairePage page, Question question, TimedAnswer given) {}
