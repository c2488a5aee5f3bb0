package org.selectiverenderer.schema;

/** The bands into which the thesis classifies consistency ratings from 1 to 6 (5.1). */
public enum RatingBand {
  /** Ratings from 1 to 3. */
  NON_EXPECTANT,
  /** Ratings above 3 and below 4. */
  NEUTRAL,
  /** Ratings from 4 to 6. */
  EXPECTANT;

  /** Returns the band of a mean rating. */
  public static RatingBand of(double rating) {
    return rating <= 3 ? NON_EXPECTANT : rating < 4 ? NEUTRAL : EXPECTANT;
  }

  /** Returns the consistency type; neutral objects are treated as expected ones. */
  public ConsistencyType consistency() {
    return this == NON_EXPECTANT ? ConsistencyType.INCONSISTENT : ConsistencyType.CONSISTENT;
  }
}
