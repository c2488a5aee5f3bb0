package org.selectiverenderer.document.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;

/**
 * Which version of an object stands for which degree of consistency: the first, with all polygons,
 * for the lowest; the last, with the fewest, for the highest; those between them for the steps
 * between (thesis 4.2.1, 7.2). Degrees that the author has given count first.
 */
public final class VersionLadder {
  private VersionLadder() {}

  /** The degree of a version of which nothing is said. */
  public static Degree degree(int index, int versions) {
    return versions < 2 ? Degree.LOW : new Degree((double) index / (versions - 1));
  }

  /** The version for a degree: the nearest one, the more detailed of two as near. */
  public static int version(Degree wanted, List<ChoiceValues> choices) {
    int best = 0;
    double distance = Double.MAX_VALUE;
    for (int i = 0; i < choices.size(); i++) {
      Degree own = choices.get(i).degree().orElse(degree(i, choices.size()));
      double far = Math.abs(own.value() - wanted.value());
      if (far < distance) {
        best = i;
        distance = far;
      }
    }
    return best;
  }

  /**
   * A choice that belongs to one schema more; type and degree are filled in where there are none.
   */
  static ChoiceValues joined(ChoiceValues choice, String schema, Degree degree) {
    List<String> schemas = new ArrayList<>(choice.schemas());
    schemas.add(schema);
    ConsistencyType type =
        degree.value() >= 0.5 ? ConsistencyType.CONSISTENT : ConsistencyType.INCONSISTENT;
    return new ChoiceValues(
        Optional.of(choice.type().orElse(type)),
        Optional.of(choice.degree().orElse(degree)),
        schemas);
  }
}
