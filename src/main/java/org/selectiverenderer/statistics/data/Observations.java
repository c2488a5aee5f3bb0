package org.selectiverenderer.statistics.data;

import java.util.List;
import org.selectiverenderer.statistics.anova.Design;

/**
 * Measurements of a file as a design.
 *
 * @param source the file
 * @param design of the subjects with complete data; it may still have an {@link Design#obstacle}
 * @param exclusions what is not in it
 */
public record Observations(DataFile source, Design design, List<Exclusion> exclusions) {
  /** Keeps copies, so that it stays as it is. */
  public Observations {
    exclusions = List.copyOf(exclusions);
  }
}
