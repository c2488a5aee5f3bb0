package org.selectiverenderer.statistics.data;

import java.util.List;

/**
 * A value that was measured on a participant: of one trial, or of several.
 *
 * @param levels its level of each factor of the analysis, in their order
 */
public record Measurement(String participant, List<String> levels, double value) {
  /** Copies the levels. */
  public Measurement {
    levels = List.copyOf(levels);
  }
}
