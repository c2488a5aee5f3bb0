package org.selectiverenderer.polygon.count;

import java.util.List;

/**
 * What the polygons of a part of the scene come from, with some schemas activated.
 *
 * @param scope DEF of the group, or {@link SceneStatistics#WHOLE_SCENE}
 * @param schemas as {@link SceneStatistics.StateCount} has them
 * @param polygons in this state
 * @param percent of what the part has when all objects show their most detailed version
 * @param fixed polygons that no object in versions has
 * @param objects in document order
 */
public record StateShares(
    String scope,
    List<String> schemas,
    long polygons,
    double percent,
    long fixed,
    List<ObjectShare> objects) {
  /** Keeps copies, so that it stays as it is. */
  public StateShares {
    schemas = List.copyOf(schemas);
    objects = List.copyOf(objects);
  }

  /**
   * An object's part. One that stands in a version of another counts in both.
   *
   * @param name as in {@link SceneStatistics.ObjectCount}
   * @param version that it shows, from 0; -1 for none
   * @param versions polygons of each version in one place
   * @param places at which it stands in the part of the scene
   * @param polygons that it shows, all places together
   */
  public record ObjectShare(
      String name, int version, List<Long> versions, int places, long polygons) {
    /** Keeps copies, so that it stays as it is. */
    public ObjectShare {
      versions = List.copyOf(versions);
    }
  }
}
