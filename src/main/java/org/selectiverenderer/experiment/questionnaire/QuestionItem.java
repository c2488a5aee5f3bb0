package org.selectiverenderer.experiment.questionnaire;

/**
 * An object that is asked about.
 *
 * @param area whose page it is on
 * @param schema of the area, for ratings of expectancy, or {@link #EXAMPLE}; else empty
 * @param object by which files know it
 * @param type consistent, inconsistent or neutral, for recognition; else empty
 * @param present whether it was in the scene; without meaning for expectancy
 */
public record QuestionItem(
    String area, String schema, String object, String type, boolean present) {
  /** In the place of a schema: the item shows how to rate, and its rating counts nowhere. */
  public static final String EXAMPLE = "example";

  /** Whether it only shows how to rate (thesis 5.1: a table and a bed in a restaurant). */
  public boolean example() {
    return schema.equals(EXAMPLE);
  }
}
