package org.selectiverenderer.statistics.data;

import java.util.List;
import org.selectiverenderer.statistics.detection.Response;

/**
 * A study's answers.
 *
 * @param source the file
 * @param usable answers, in the order of the file
 * @param exclusions what is not among them, and what is wanting
 */
public record Responses(DataFile source, List<Response> usable, List<Exclusion> exclusions) {
  /** Keeps copies, so that it stays as it is. */
  public Responses {
    usable = List.copyOf(usable);
    exclusions = List.copyOf(exclusions);
  }
}
