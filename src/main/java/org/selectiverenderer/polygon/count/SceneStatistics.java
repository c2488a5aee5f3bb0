package org.selectiverenderer.polygon.count;

import java.util.List;
import java.util.Optional;

/**
 * The polygon counts of a scene.
 *
 * @param scene the file, as the user named it
 * @param totalHigh polygons of the whole scene when all objects show their most detailed version
 * @param objects the enriched Switches, scope by scope in document order; those in no scope last
 * @param scopes the parts of the scene that are looked at, in document order or as asked for
 */
public record SceneStatistics(
    String scene, long totalHigh, List<ObjectCount> objects, List<ScopeCount> scopes) {
  /** What stands for the scope when the whole scene is one. */
  public static final String WHOLE_SCENE = "scene";

  /** Keeps copies, so that it stays as it is. */
  public SceneStatistics {
    objects = List.copyOf(objects);
    scopes = List.copyOf(scopes);
  }

  /**
   * An object in versions (Figs 67, 69, 71).
   *
   * @param switchName DEF of the Switch, or {@code Switch#3} for the third one if it has none
   * @param scope empty if the Switch stands in none
   * @param versions polygons of each child, in order
   * @param original index of the version that the metadata make the most detailed
   */
  public record ObjectCount(
      String switchName, Optional<String> scope, List<Long> versions, int original) {
    /** Keeps copies, so that it stays as it is. */
    public ObjectCount {
      versions = List.copyOf(versions);
    }

    /** A version's polygons as a percentage of the original's; 0 if that has none. */
    public double percent(int version) {
      return percentage(versions.get(version), versions.get(original));
    }
  }

  /**
   * A part of the scene.
   *
   * @param scope DEF of the group
   * @param high polygons when all objects show their most detailed version
   * @param states as loaded, in each area, and in each set of overlapping areas
   */
  public record ScopeCount(String scope, long high, List<StateCount> states) {
    /** Keeps copies, so that it stays as it is. */
    public ScopeCount {
      states = List.copyOf(states);
    }
  }

  /**
   * A scope with some schemas activated (Tables 3-5).
   *
   * @param schemas as loaded: those that all objects follow; else those that the areas activate, in
   *     the order of entering
   * @param percent of {@link ScopeCount#high}; 0 if that is 0
   */
  public record StateCount(List<String> schemas, long polygons, double percent) {
    /** Keeps copies, so that it stays as it is. */
    public StateCount {
      schemas = List.copyOf(schemas);
    }

    /**
     * @param high the polygons that are 100 %
     */
    static StateCount of(List<String> schemas, long polygons, long high) {
      return new StateCount(schemas, polygons, percentage(polygons, high));
    }
  }

  /** The objects of a scope. */
  public List<ObjectCount> objectsOf(ScopeCount scope) {
    return objects.stream()
        .filter(object -> object.scope().equals(Optional.of(scope.scope())))
        .toList();
  }

  private static double percentage(long part, long whole) {
    return whole == 0 ? 0 : 100.0 * part / whole;
  }
}
