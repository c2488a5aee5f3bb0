package org.selectiverenderer.experiment.questionnaire;

/**
 * A row of a table of answers.
 *
 * @param page the page of the question
 * @param given the answer; {@link GivenAnswer#NONE} for none
 */
public record TabledAnswer(Page page, Question question, GivenAnswer given) {}
