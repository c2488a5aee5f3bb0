package org.selectiverenderer.experiment.questionnaire;

/**
 * Whom a questionnaire was put to.
 *
 * @param session its number; empty for answers on paper
 * @param condition empty before it is assigned
 * @param questionnaire the id of the step
 */
public record AskedBy(String participant, String session, String condition, String questionnaire) {}
