package org.selectiverenderer.schema;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The schemas that select the levels of a quality. Consistency is that of an object with a schema,
 * whichever of its qualities is chosen: so levels that name no schema take those of the object's
 * versions, each version's the level of the nearest degree.
 */
final class LevelSchemas {
  private final List<FieldLevel> levels = new ArrayList<>();

  /** Levels without type and degree get degrees that are spaced evenly, the first the lowest. */
  LevelSchemas(List<FieldLevel> written) {
    for (int i = 0; i < written.size(); i++) {
      VersionMetadata metadata = written.get(i).metadata();
      levels.add(with(written.get(i), degreeOf(metadata, written.size()), metadata.schemas()));
    }
  }

  /** Returns whether a level names a schema. */
  boolean own() {
    return levels.stream().anyMatch(level -> !level.metadata().schemas().isEmpty());
  }

  /** Takes the schemas of an object's versions; returns whether there are any. */
  boolean follow(List<VersionMetadata> versions) {
    for (VersionMetadata version : versions) {
      int nearest = nearest(degree(version, versions.size()));
      List<String> schemas = new ArrayList<>(levels.get(nearest).metadata().schemas());
      schemas.addAll(version.schemas());
      FieldLevel level = levels.get(nearest);
      levels.set(nearest, with(level, level.metadata().degree(), schemas));
    }
    return own();
  }

  List<FieldLevel> levels() {
    return List.copyOf(levels);
  }

  /** Returns the level of the nearest degree; of two equally near the better one. */
  private int nearest(double wanted) {
    int best = 0;
    for (int i = 1; i < levels.size(); i++) {
      if (distance(i, wanted) < distance(best, wanted)) {
        best = i;
      }
    }
    return best;
  }

  private double distance(int level, double wanted) {
    return Math.abs(levels.get(level).metadata().consistency() - wanted);
  }

  private static double degree(VersionMetadata version, int count) {
    return degreeOf(version, count).map(ConsistencyDegree::value).orElseGet(version::consistency);
  }

  /** Returns the degree in the metadata; without a type too one by the place among the others. */
  private static Optional<ConsistencyDegree> degreeOf(VersionMetadata metadata, int count) {
    return metadata.degree().isPresent() || metadata.type().isPresent()
        ? metadata.degree()
        : Optional.of(
            count < 2
                ? ConsistencyDegree.LOW
                : new ConsistencyDegree((double) metadata.index() / (count - 1)));
  }

  private static FieldLevel with(
      FieldLevel level, Optional<ConsistencyDegree> degree, List<String> schemas) {
    VersionMetadata metadata = level.metadata();
    return new FieldLevel(
        new VersionMetadata(metadata.index(), metadata.type(), degree, schemas), level.values());
  }
}
