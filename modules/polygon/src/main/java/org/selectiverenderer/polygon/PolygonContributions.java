package org.selectiverenderer.polygon;

import java.util.List;

/**
 * The contributions of objects to the polygons of a part of the scene, with some schemas activated.
 *
 * @param scope DEF name of the group, or {@link SceneStatistics#WHOLE_SCENE}
 * @param schemas schemas as in {@link SceneStatistics.StateCount}
 * @param polygons number of polygons in this state
 * @param percent polygons in percent of those with all objects in their most detailed version
 * @param fixed polygons outside of versioned objects
 * @param objects versioned objects in document order
 * @param cost what the state costs beside polygons
 */
public record PolygonContributions(
    String scope,
    List<String> schemas,
    long polygons,
    double percent,
    long fixed,
    List<ObjectShare> objects,
    RenderingCost cost) {
  /** Makes defensive copies, so that the record is immutable. */
  public PolygonContributions {
    schemas = List.copyOf(schemas);
    objects = List.copyOf(objects);
  }

  /**
   * The contribution of an object. An object nested in a version of another counts in both.
   *
   * @param name name as in {@link SceneStatistics.ObjectCount}
   * @param version index of the shown version, from 0; -1 for none
   * @param versions polygons of each version of one instance
   * @param places number of instances in the part of the scene
   * @param polygons polygons shown by all instances together
   */
  public record ObjectShare(
      String name, int version, List<Long> versions, int places, long polygons) {
    /** Makes defensive copies, so that the record is immutable. */
    public ObjectShare {
      versions = List.copyOf(versions);
    }
  }
}
