package org.selectiverenderer.validation;

import java.util.List;

/**
 * A polygon budget: the greatest number of polygons that a part of a scene may show.
 *
 * @param file the scene's file, relative to the settings file's folder; empty for every scene
 * @param scope DEF name of a group; empty for the whole scene
 * @param schemas the active schemas of the state that the budget is for; empty for the worst state
 *     that a viewer can reach
 * @param polygons greatest number of polygons
 */
public record PolygonBudget(String file, String scope, List<String> schemas, long polygons) {
  /** Makes defensive copies, so that the record is immutable. */
  public PolygonBudget {
    schemas = List.copyOf(schemas);
  }

  /** Creates a budget for every scene that has its group and schemas. */
  public PolygonBudget(String scope, List<String> schemas, long polygons) {
    this("", scope, schemas, polygons);
  }
}
