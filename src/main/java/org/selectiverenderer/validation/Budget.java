package org.selectiverenderer.validation;

import java.util.List;

/**
 * The polygons that a part of a scene may have.
 *
 * @param scope DEF name of a group; empty for the whole scene
 * @param schemas the state in which it holds, by its active schemas; empty for the worst state that
 *     a viewer can reach
 * @param polygons at most
 */
public record Budget(String scope, List<String> schemas, long polygons) {
  /** Keeps copies, so that it stays as it is. */
  public Budget {
    schemas = List.copyOf(schemas);
  }
}
