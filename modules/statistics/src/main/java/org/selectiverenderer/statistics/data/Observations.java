package org.selectiverenderer.statistics.data;

import java.util.List;
import org.selectiverenderer.statistics.anova.FactorialDesign;

/**
 * The measurements of a file as a design.
 *
 * @param source the file
 * @param design the design of the subjects with complete data; it may still have an {@link
 *     FactorialDesign#obstacle}
 * @param exclusions rows and subjects that the design leaves out
 */
public record Observations(DataSource source, FactorialDesign design, List<Exclusion> exclusions) {
  /** Makes defensive copies, so that the record is immutable. */
  public Observations {
    exclusions = List.copyOf(exclusions);
  }
}
