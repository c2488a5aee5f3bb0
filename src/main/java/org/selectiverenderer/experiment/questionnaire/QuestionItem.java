package org.selectiverenderer.experiment.questionnaire;

import java.util.Map;

/**
 * An object that is asked about.
 *
 * @param area whose screen it is on
 * @param schema of the area, for ratings of expectancy; else empty
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
  public QuestionItem {
    names = Map.copyOf(names);
  }
}
