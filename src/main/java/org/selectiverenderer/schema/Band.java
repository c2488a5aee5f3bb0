package org.selectiverenderer.schema;

/** The bands into which the thesis sorts ratings from 1 to 6 (5.1). */
public enum Band {
  /** 1 to 3. */
  NON_EXPECTANT,
  /** Above 3 and below 4. */
  NEUTRAL,
  /** 4 to 6. */
  EXPECTANT;

  /** The band of a mean rating. */
  public static Band of(double rating) {
    return rating <= 3 ? NON_EXPECTANT : rating < 4 ? NEUTRAL : EXPECTANT;
  }

  /** Only what people do not expect is inconsistent; neutral objects are drawn as expected ones. */
  public ConsistencyType consistency() {
    return this == NON_EXPECTANT ? ConsistencyType.INCONSISTENT : ConsistencyType.CONSISTENT;
  }
}
