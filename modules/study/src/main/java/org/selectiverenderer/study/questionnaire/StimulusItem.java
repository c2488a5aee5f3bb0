package org.selectiverenderer.study.questionnaire;

/**
 * An item of a recognition list or an expectancy questionnaire: an object that is asked about.
 *
 * @param area the area on whose page the item is
 * @param schema memory schema of the area, for ratings of expectancy, or {@link #EXAMPLE}; else
 *     empty
 * @param object the object's name in files
 * @param type consistency with the schema (consistent, inconsistent or neutral), for recognition;
 *     else empty
 * @param present whether the object was in the scene; not used for expectancy
 */
public record StimulusItem(
    String area, String schema, String object, String type, boolean present) {
  /** Marks, instead of a schema, an example that shows how to rate and does not count. */
  public static final String EXAMPLE = "example";

  /** Returns whether the item is an example (thesis 5.1: a table and a bed in a restaurant). */
  public boolean example() {
    return schema.equals(EXAMPLE);
  }
}
