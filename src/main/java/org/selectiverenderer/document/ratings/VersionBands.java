package org.selectiverenderer.document.ratings;

import org.selectiverenderer.document.enrichment.ChoiceValues;
import org.selectiverenderer.document.enrichment.VersionLadder;
import org.selectiverenderer.schema.Band;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;

/** Maps a mean rating to a version of an object (thesis 5.1; 7.2 for more than two versions). */
final class VersionBands {
  private VersionBands() {}

  /**
   * Returns the version: the first for an unexpected object, the last for an expected one. A
   * neutral object is shown like an expected one if there are two versions, else by a version
   * between, a later one for a higher rating.
   */
  static int version(double mean, int versions) {
    return switch (Band.of(mean)) {
      case NON_EXPECTANT -> 0;
      case EXPECTANT -> versions - 1;
      case NEUTRAL ->
          versions == 2
              ? 1
              : Math.min(versions - 2, 1 + (int) Math.floor((mean - 3) * (versions - 2)));
    };
  }

  /** Returns the type and degree of a version that ratings imply. */
  static ChoiceValues values(int version, int versions) {
    Degree degree = VersionLadder.degree(version, versions);
    ConsistencyType type = version == 0 ? ConsistencyType.INCONSISTENT : ConsistencyType.CONSISTENT;
    return ChoiceValues.NONE.with(type).with(degree);
  }
}
