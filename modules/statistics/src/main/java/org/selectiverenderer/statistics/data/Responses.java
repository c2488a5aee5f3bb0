package org.selectiverenderer.statistics.data;

import java.util.List;
import org.selectiverenderer.statistics.detection.Response;

/**
 * The answers of a study.
 *
 * @param source the file
 * @param usable the answers that analyses use, in the order of the file
 * @param exclusions the answers left out, and those missing
 */
public record Responses(DataSource source, List<Response> usable, List<Exclusion> exclusions) {
  /** Makes defensive copies, so that the record is immutable. */
  public Responses {
    usable = List.copyOf(usable);
    exclusions = List.copyOf(exclusions);
  }
}
