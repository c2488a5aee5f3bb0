package org.selectiverenderer.study.threshold;

import java.util.Locale;

/**
 * The estimate of one participant's threshold for one object.
 *
 * @param polygons the threshold in polygons; if it lies beyond the versions, the polygons of the
 *     first or last one
 */
record ThresholdEstimate(Kind kind, double polygons) {
  /** Where the threshold lies. */
  public enum Kind {
    /** Between the versions shown. */
    FOUND,
    /** Below the fewest polygons, which were enough already. */
    BELOW,
    /** Above the most polygons, which were still told from the original, or not recognised. */
    ABOVE,
    /** Unknown, as the trials ended before it was found. */
    OPEN;

    /** Returns the spelling in logs and tables. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT);
    }
  }
}
