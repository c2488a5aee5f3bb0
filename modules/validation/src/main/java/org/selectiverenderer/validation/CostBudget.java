package org.selectiverenderer.validation;

import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A budget: the most that a part of a scene may cost.
 *
 * @param file the scene's file, relative to the settings file's folder; empty for every scene
 * @param scope DEF name of a group; empty for the whole scene
 * @param schemas the active schemas of the state that the budget is for; empty for the worst state
 *     that a viewer can reach
 * @param limits the greatest numbers, at least one
 */
public record CostBudget(
    String file, String scope, List<String> schemas, Map<CostKind, Long> limits) {
  /** Makes defensive copies, so that the record is immutable. */
  public CostBudget {
    schemas = List.copyOf(schemas);
    Map<CostKind, Long> ordered = new EnumMap<>(CostKind.class);
    ordered.putAll(limits);
    limits = Collections.unmodifiableMap(ordered);
  }

  /** Creates a budget of polygons for one file. */
  public CostBudget(String file, String scope, List<String> schemas, long polygons) {
    this(file, scope, schemas, Map.of(CostKind.POLYGONS, polygons));
  }

  /** Creates a budget of polygons for every scene that has its group and schemas. */
  public CostBudget(String scope, List<String> schemas, long polygons) {
    this("", scope, schemas, polygons);
  }

  /** Returns a limit; empty if it is not limited. */
  public Optional<Long> limit(CostKind kind) {
    return Optional.ofNullable(limits.get(kind));
  }
}
