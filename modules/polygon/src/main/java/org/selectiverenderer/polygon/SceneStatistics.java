package org.selectiverenderer.polygon;

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
  /** The name of the scope when it is the whole scene. */
  public static final String WHOLE_SCENE = "scene";

  /** Makes defensive copies, so that the record is immutable. */
  public SceneStatistics {
    objects = List.copyOf(objects);
    scopes = List.copyOf(scopes);
  }

  /**
   * A versioned object (Figs 67, 69, 71).
   *
   * @param switchName DEF of the Switch, or {@code Switch#3} for the third one if it has none
   * @param scope the scope that contains the Switch; empty for none
   * @param versions number of polygons of each child, in order
   * @param original index of the version that is the most detailed according to the metadata
   */
  public record ObjectCount(
      String switchName, Optional<String> scope, List<Long> versions, int original) {
    /** Makes defensive copies, so that the record is immutable. */
    public ObjectCount {
      versions = List.copyOf(versions);
    }

    /**
     * Returns the polygons of a version as a percentage of the original's; 0 if the original has
     * none.
     */
    public double percent(int version) {
      return percentage(versions.get(version), versions.get(original));
    }
  }

  /**
   * The counts of a part of the scene.
   *
   * @param scope DEF name of the group
   * @param high number of polygons when all objects show their most detailed version
   * @param states the states: as loaded, in each area, and in each set of overlapping areas
   * @param highCost what {@code high} costs beside polygons
   */
  public record ScopeCount(
      String scope, long high, List<StateCount> states, RenderingCost highCost) {
    /** Makes the counts of a part of which polygons alone are known. */
    public ScopeCount(String scope, long high, List<StateCount> states) {
      this(scope, high, states, RenderingCost.NONE);
    }

    /** Makes defensive copies, so that the record is immutable. */
    public ScopeCount {
      states = List.copyOf(states);
    }
  }

  /**
   * The count of a scope with some schemas activated (Tables 3-5).
   *
   * @param schemas for the state as loaded, the schemas that all objects follow; else those that
   *     the areas activate, in the order of entering
   * @param percent polygons in percent of {@link ScopeCount#high}; 0 if that is 0
   * @param cost what the state costs beside polygons
   */
  public record StateCount(
      List<String> schemas, long polygons, double percent, RenderingCost cost) {
    /** Makes the count of a state of which polygons alone are known. */
    public StateCount(List<String> schemas, long polygons, double percent) {
      this(schemas, polygons, percent, RenderingCost.NONE);
    }

    /** Makes defensive copies, so that the record is immutable. */
    public StateCount {
      schemas = List.copyOf(schemas);
    }

    /**
     * @param high the polygons that are 100 %
     */
    static StateCount of(List<String> schemas, long polygons, long high, RenderingCost cost) {
      return new StateCount(schemas, polygons, percentage(polygons, high), cost);
    }
  }

  /** Returns the objects of a scope. */
  public List<ObjectCount> objectsOf(ScopeCount scope) {
    return objects.stream()
        .filter(object -> object.scope().equals(Optional.of(scope.scope())))
        .toList();
  }

  private static double percentage(long part, long whole) {
    return whole == 0 ? 0 : 100.0 * part / whole;
  }
}
