package org.selectiverenderer.browser.nodes.picking;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Decides which pickable groups a pick sensor addresses (X3D 4.0, 38.3.1 and 38.3.2): their {@code
 * objectType}s are compared with those of the sensor by its {@code matchCriterion}.
 *
 * @param wanted the sensor's {@code objectType}s
 */
public record ObjectTypeMatcher(List<String> wanted, Criterion criterion) {
  private static final String ALL = "ALL";
  private static final String NONE = "NONE";

  /** The {@code matchCriterion}: how many labels have to match. */
  public enum Criterion {
    MATCH_ANY,
    MATCH_EVERY,
    MATCH_ONLY_ONE;

    /** Returns the criterion of a name; the standard's default for an unknown name. */
    static Criterion of(String name) {
      for (Criterion criterion : values()) {
        if (criterion.name().equals(name)) {
          return criterion;
        }
      }
      return MATCH_ANY;
    }
  }

  public ObjectTypeMatcher {
    wanted = List.copyOf(wanted);
  }

  /** Returns whether the sensor picks nothing at all. */
  public boolean none() {
    return wanted.contains(NONE);
  }

  /** Returns whether the sensor picks a group with these labels. */
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
