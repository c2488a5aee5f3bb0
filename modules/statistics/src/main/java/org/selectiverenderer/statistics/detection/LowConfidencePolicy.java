package org.selectiverenderer.statistics.detection;

/**
 * How answers below a {@link ConfidenceThreshold} are scored. The thesis says that "only
 * recognition scores with corresponding confidence ratings" were used, which reads as {@link
 * #DISCARD}. Its tables, where the bias towards "no" grows with the level while the number of
 * objects stays, look like {@link #AS_NO}.
 */
public enum LowConfidencePolicy {
  /** They are left out, as if the participant had not been asked about the object. */
  DISCARD,
  /** They count as "no": an object recognised without confidence is not recognised. */
  AS_NO
}
