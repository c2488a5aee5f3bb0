package org.selectiverenderer.schema;

import java.util.List;

/**
 * The schemas of an area (thesis Figs 42, 47, 77), each list in the order of the metadata, without
 * repetition.
 *
 * @param enter the schemas activated when the viewer enters the area
 * @param exit the schemas activated when the viewer leaves the area
 */
public record SensorSchemas(List<String> enter, List<String> exit) {
  /** Makes defensive copies of the lists. */
  public SensorSchemas {
    enter = List.copyOf(enter);
    exit = List.copyOf(exit);
  }
}
