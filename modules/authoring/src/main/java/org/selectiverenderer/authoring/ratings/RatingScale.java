package org.selectiverenderer.authoring.ratings;

import java.util.List;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.VersionDegreeMapping;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.RatingBand;

/** How mean ratings from 1 to 6 choose among the versions of an object. */
public enum RatingScale {
  /**
   * The bands of thesis 5.1: the first version for an unexpected object, the last for an expected
   * one. A neutral object is shown like an expected one if there are two versions, else by a
   * version between, a later one for a higher rating.
   */
  BANDS {
    @Override
    int version(double mean, List<ChoiceMetadata> choices) {
      int versions = choices.size();
      return switch (RatingBand.of(mean)) {
        case NON_EXPECTANT -> 0;
        case EXPECTANT -> versions - 1;
        case NEUTRAL ->
            versions == 2
                ? 1
                : Math.min(versions - 2, 1 + (int) Math.floor((mean - 3) * (versions - 2)));
      };
    }

    @Override
    ChoiceMetadata values(int version, List<ChoiceMetadata> choices) {
      ConsistencyType type =
          version == 0 ? ConsistencyType.INCONSISTENT : ConsistencyType.CONSISTENT;
      return ChoiceMetadata.NONE
          .with(type)
          .with(VersionDegreeMapping.degree(version, choices.size()));
    }

    @Override
    List<ChoiceMetadata> complete(List<ChoiceMetadata> choices) {
      // A version between the first and the last would else be the most consistent one.
      return VersionDegreeMapping.isScale(choices)
          ? VersionDegreeMapping.complete(choices)
          : choices;
    }
  },

  /**
   * Consistency as a scale (thesis 7.2): a rating of 1 is the degree 0, of 6 the degree 1, evenly
   * between, and the version of the nearest degree is shown. Degrees that the scene has count, else
   * those of {@link VersionDegreeMapping}.
   */
  LINEAR {
    @Override
    int version(double mean, List<ChoiceMetadata> choices) {
      return VersionDegreeMapping.version(new ConsistencyDegree(degree(mean)), choices);
    }

    @Override
    ChoiceMetadata values(int version, List<ChoiceMetadata> choices) {
      ConsistencyDegree degree =
          choices
              .get(version)
              .degree()
              .orElse(VersionDegreeMapping.degree(version, choices.size()));
      ConsistencyType type =
          degree.value() >= 0.5 ? ConsistencyType.CONSISTENT : ConsistencyType.INCONSISTENT;
      return ChoiceMetadata.NONE.with(type).with(degree);
    }

    @Override
    List<ChoiceMetadata> complete(List<ChoiceMetadata> choices) {
      return VersionDegreeMapping.complete(choices);
    }
  };

  private static final double LEAST = 1;
  private static final double MOST = 6;

  /** Returns the degree of consistency, 0 to 1, that a mean rating is on the linear scale. */
  public static double degree(double mean) {
    return Math.max(0, Math.min(1, (mean - LEAST) / (MOST - LEAST)));
  }

  /**
   * Returns the version for a mean rating.
   *
   * @param choices the versions with the metadata that they have
   */
  abstract int version(double mean, List<ChoiceMetadata> choices);

  /** Returns the type and degree of a version that ratings imply. */
  abstract ChoiceMetadata values(int version, List<ChoiceMetadata> choices);

  /**
   * Fills in the missing degrees of versions that no rating chooses, where the degrees of the
   * others form a scale.
   */
  abstract List<ChoiceMetadata> complete(List<ChoiceMetadata> choices);
}
