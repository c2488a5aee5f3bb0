package org.selectiverenderer.schema;

import java.util.List;

/**
 * The schemas of an area (thesis Figs 42, 47, 77), each list in the order of the metadata, without
 * repetition.
 *
 * @param enter activated on entering
 * @param exit activated on leaving
 */
public record SensorSchemas(List<String> enter, List<String> exit) {
  /** Keeps copies, so that it stays as it is. */
  public SensorSchemas {
    enter = List.copyOf(enter);
    exit = List.copyOf(exit);
  }
}
