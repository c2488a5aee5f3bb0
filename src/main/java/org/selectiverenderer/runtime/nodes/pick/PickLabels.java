package org.selectiverenderer.runtime.nodes.pick;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Which of what stands in pickable groups a sensor is for (X3D 4.0, 38.3.1 and 38.3.2): their
 * {@code objectType}s are compared as the sensor's {@code matchCriterion} says.
 *
 * @param wanted the sensor's labels
 */
public record PickLabels(List<String> wanted, Criterion criterion) {
  private static final String ALL = "ALL";
  private static final String NONE = "NONE";

  /** How many labels have to be the same. */
  public enum Criterion {
    MATCH_ANY,
    MATCH_EVERY,
    MATCH_ONLY_ONE;

    /** That of a name; the standard's default for any other. */
    static Criterion of(String name) {
      for (Criterion criterion : values()) {
        if (criterion.name().equals(name)) {
          return criterion;
        }
      }
      return MATCH_ANY;
    }
  }

  public PickLabels {
    wanted = List.copyOf(wanted);
  }

  /** Whether the sensor picks nothing whatever it meets. */
  public boolean none() {
    return wanted.contains(NONE);
  }

  /** Whether it picks what is labelled so. */
  public boolean fit(List<String> labels) {
    if (none() || labels.contains(NONE)) {
      return false;
    }
    if (wanted.contains(ALL) || labels.contains(ALL)) {
      return true;
    }
    Set<String> same = new HashSet<>(wanted);
    same.retainAll(labels);
    return switch (criterion) {
      case MATCH_ANY -> !same.isEmpty();
      case MATCH_EVERY -> same.containsAll(wanted) && same.containsAll(labels);
      case MATCH_ONLY_ONE -> same.size() == 1;
    };
  }
}
