package org.selectiverenderer.experiment.threshold;

import java.util.Locale;

/**
 * What one participant's trials with one object come to.
 *
 * @param polygons the threshold; of the fewest or the most that were shown where it lies beyond
 */
record ThresholdEstimate(Kind kind, double polygons) {
  /** Where a threshold lies. */
  public enum Kind {
    /** Between the versions that were shown. */
    FOUND,
    /** Below the fewest polygons: these were enough already. */
    BELOW,
    /** Above the most: even these were told from the original, or not recognised. */
    ABOVE,
    /** The trials ended before it was found. */
    OPEN;

    /** As logs and tables write it. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT);
    }
  }
}
