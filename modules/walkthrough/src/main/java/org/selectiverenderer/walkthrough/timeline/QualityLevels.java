package org.selectiverenderer.walkthrough.timeline;

import java.util.List;
import org.selectiverenderer.schema.Quality;

/**
 * How long the fields of one quality had which levels in a walkthrough.
 *
 * @param fields number of fields at the end
 * @param levels the levels that a field had, ascending
 */
public record QualityLevels(Quality quality, int fields, List<Level> levels) {
  public QualityLevels {
    levels = List.copyOf(levels);
  }

  /**
   * A level.
   *
   * @param level from 0, the order of the metadata; -1 for values of no level
   * @param seconds how long fields had it, the sum over the fields
   * @param end number of fields that have it at the end
   */
  public record Level(int level, double seconds, int end) {}

  /** Returns the seconds of all levels. */
  double seconds() {
    return levels.stream().mapToDouble(Level::seconds).sum();
  }
}
