package org.selectiverenderer.experiment.questionnaire;

/**
 * An answer that tables may have.
 *
 * @param page on which the question was asked
 * @param given {@link GivenAnswer#NONE} where there is no answer
 */
public record TabledAnswer(Page page, Question question, GivenAnswer given) {}
