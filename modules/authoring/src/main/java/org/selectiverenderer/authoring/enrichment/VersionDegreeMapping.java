package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;

/**
 * Maps the versions of an object to degrees of consistency: the first version, with all polygons,
 * has the lowest degree, the last one, with the fewest polygons, the highest, and those between are
 * spaced evenly (thesis 4.2.1, 7.2). Degrees in the metadata take precedence.
 */
public final class VersionDegreeMapping {
  /** Distances that differ by less are equal, since degrees are rounded to four decimals. */
  private static final double EQUAL = 2e-4;

  private VersionDegreeMapping() {}

  /** Returns the degree of a version without metadata, in at most four decimals. */
  public static ConsistencyDegree degree(int index, int versions) {
    return versions < 2
        ? ConsistencyDegree.LOW
        : new ConsistencyDegree(DecimalRounding.to(4, (double) index / (versions - 1)));
  }

  /** Returns the version whose degree is nearest; of two equally near the more detailed one. */
  public static int version(ConsistencyDegree wanted, List<ChoiceMetadata> choices) {
    int best = 0;
    double distance = Double.MAX_VALUE;
    for (int i = 0; i < choices.size(); i++) {
      ConsistencyDegree own = choices.get(i).degree().orElse(degree(i, choices.size()));
      double far = Math.abs(own.value() - wanted.value());
      if (far < distance - EQUAL || far == 0 && distance > 0) {
        best = i;
        distance = far;
      }
    }
    return best;
  }

  /**
   * Fills in the missing degrees of an object's versions, so that its least detailed version stays
   * the last. A degree lies between those before and behind it that are there.
   */
  public static List<ChoiceMetadata> complete(List<ChoiceMetadata> choices) {
    List<ChoiceMetadata> complete = new ArrayList<>();
    ConsistencyDegree before = ConsistencyDegree.LOW;
    for (int i = 0; i < choices.size(); i++) {
      ConsistencyDegree most =
          choices.subList(i, choices.size()).stream()
              .flatMap(choice -> choice.degree().stream())
              .findFirst()
              .orElse(ConsistencyDegree.HIGH);
      ConsistencyDegree even = degree(i, choices.size());
      ConsistencyDegree least = before.compareTo(even) > 0 ? before : even;
      ConsistencyDegree own =
          choices.get(i).degree().orElse(least.compareTo(most) < 0 ? least : most);
      complete.add(choices.get(i).with(own));
      before = own;
    }
    return complete;
  }

  /** Returns whether an object's degrees form a scale: one lies between the least and the most. */
  public static boolean isScale(List<ChoiceMetadata> choices) {
    return choices.stream()
        .flatMap(choice -> choice.degree().stream())
        .anyMatch(degree -> degree.value() > 0 && degree.value() < 1);
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
