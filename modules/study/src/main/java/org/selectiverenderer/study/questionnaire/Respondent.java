package org.selectiverenderer.study.questionnaire;

/**
 * The respondent of a questionnaire: who answered it, in which session and condition.
 *
 * @param session number of the session; empty for answers on paper
 * @param condition the participant's condition; empty before it is assigned
 * @param questionnaire id of the step
 */
public record Respondent(
    String participant, String session, String condition, String questionnaire) {}
