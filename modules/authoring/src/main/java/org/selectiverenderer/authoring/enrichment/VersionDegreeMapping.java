package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;

/**
 * Maps the versions of an object to degrees of consistency: the first version, with all polygons,
 * has the lowest degree, the last one, with the fewest polygons, the highest, and those between are
 * spaced evenly (thesis 4.2.1, 7.2). Degrees in the metadata take precedence.
 */
public final class VersionDegreeMapping {
  private VersionDegreeMapping() {}

  /** Returns the degree of a version without metadata. */
  public static ConsistencyDegree degree(int index, int versions) {
    return versions < 2
        ? ConsistencyDegree.LOW
        : new ConsistencyDegree((double) index / (versions - 1));
  }

  /** Returns the version whose degree is nearest; of two equally near the more detailed one. */
  public static int version(ConsistencyDegree wanted, List<ChoiceMetadata> choices) {
    int best = 0;
    double distance = Double.MAX_VALUE;
    for (int i = 0; i < choices.size(); i++) {
      ConsistencyDegree own = choices.get(i).degree().orElse(degree(i, choices.size()));
      double far = Math.abs(own.value() - wanted.value());
      if (far < distance) {
        best = i;
        distance = far;
      }
    }
    return best;
  }

  /** Adds a schema to the metadata of a choice; missing type and degree are filled in. */
  static ChoiceMetadata joined(ChoiceMetadata choice, String schema, ConsistencyDegree degree) {
    List<String> schemas = new ArrayList<>(choice.schemas());
    schemas.add(schema);
    ConsistencyType type =
        degree.value() >= 0.5 ? ConsistencyType.CONSISTENT : ConsistencyType.INCONSISTENT;
    return new ChoiceMetadata(
        Optional.of(choice.type().orElse(type)),
        Optional.of(choice.degree().orElse(degree)),
        schemas);
  }
}
