package org.selectiverenderer.experiment.questionnaire;

import java.util.Map;

/**
 * An object that is asked about.
 *
 * @param area whose screen it is on
 * @param schema of the area, for ratings of expectancy, or {@link #EXAMPLE}; else empty
 * @param object by which files know it
 * @param type consistent, inconsistent or neutral, for recognition; else empty
 * @param present whether it was in the scene; without meaning for expectancy
 * @param names what it is called, by language
 */
public record QuestionItem(
    String area,
    String schema,
    String object,
    String type,
    boolean present,
    Map<String, String> names) {
  /** In the place of a schema: the item shows how to rate, and its rating counts nowhere. */
  public static final String EXAMPLE = "example";

  public QuestionItem {
    names = Map.copyOf(names);
  }

  /** Whether it only shows how to rate (thesis 5.1: a table and a bed in a restaurant). */
  public boolean example() {
    return schema.equals(EXAMPLE);
  }
}
