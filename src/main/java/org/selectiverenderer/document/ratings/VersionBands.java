package org.selectiverenderer.document.ratings;

import org.selectiverenderer.document.enrichment.ChoiceValues;
import org.selectiverenderer.document.enrichment.VersionLadder;
import org.selectiverenderer.schema.Band;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;

/**
 * Which version of an object a mean rating asks for (thesis 5.1; 7.2 for more than two versions).
 */
final class VersionBands {
  private VersionBands() {}

  /**
   * The version: the first for what is not expected, the last for what is. What is neutral is shown
   * as what is expected where there are two versions, else by one between, the higher the rating
   * the further on.
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

  /** What is said of a version that ratings show. */
  static ChoiceValues values(int version, int versions) {
    Degree degree = VersionLadder.degree(version, versions);
    ConsistencyType type = version == 0 ? ConsistencyType.INCONSISTENT : ConsistencyType.CONSISTENT;
    return ChoiceValues.NONE.with(type).with(degree);
  }
}
