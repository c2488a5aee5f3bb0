package org.selectiverenderer.experiment.questionnaire;

/**
 * An object that is asked about.
 *
 * @param area whose page it is on
 * @param schema of the area, for ratings of expectancy; else empty
 * @param object by which files know it
 * @param type consistent, inconsistent or neutral, for recognition; else empty
 * @param present whether it was in the scene; without meaning for expectancy
 */
public record QuestionItem(
    String area, String schema, String object, String type, boolean present) {}
