package org.selectiverenderer.walkthrough.budget;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.SubtreeMeasurement;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Tells what the versions of an object cost, and how large it is in each of its places.
 *
 * @param instances of its Switch
 * @param costs triangles of each version, in all places together
 * @param places the instances in which some version has an extent
 * @param nested whether a version contains another object
 */
record MeasuredObject(
    List<Instance> instances, List<Long> costs, List<Place> places, boolean nested) {
  /**
   * The size of an object in one place.
   *
   * @param radius of a sphere around it
   * @param disc radius of a disc as large as its mean shadow
   * @param localMiddle in the coordinates of the place
   */
  record Place(Instance instance, double radius, double disc, Vector3d localMiddle) {
    /**
     * Sets the size by a box in the world: the mean shadow of a convex body is a quarter of its
     * surface (Cauchy).
     */
    static Place of(Instance instance, BoundingBox box) {
      double w = box.width();
      double h = box.height();
      double d = box.depth();
      Vector3d middle = box.min().add(box.max()).mul(0.5);
      Matrix4d inverse = instance.world().invert(new Matrix4d());
      return new Place(
          instance,
          Math.sqrt(w * w + h * h + d * d) / 2,
          Math.sqrt((w * h + h * d + d * w) / 2 / Math.PI),
          // Under a scale of 0 the object has no extent either, and stays where it is.
          inverse.isFinite() ? inverse.transformPosition(middle) : middle);
    }
  }

  /**
   * Measures an object.
   *
   * @param instances of its Switch
   * @param switches those of all objects: one inside another is chosen for itself
   */
  static MeasuredObject of(List<Instance> instances, int versions, Set<Node> switches) {
    long[] triangles = new long[versions];
    List<Place> places = new ArrayList<>();
    boolean[] nested = new boolean[1];
    for (Instance instance : instances) {
      List<Instance> children = ((GroupInstance) instance).children();
      BoundingBox all = BoundingBox.EMPTY;
      for (int version = 0; version < Math.min(versions, children.size()); version++) {
        SubtreeMeasurement measured =
            SubtreeMeasurement.of(
                children.get(version),
                node -> {
                  boolean inner = switches.contains(node);
                  nested[0] |= inner;
                  return inner;
                });
        triangles[version] += measured.triangles();
        all = all.union(measured.bounds());
      }
      if (!all.isEmpty()) {
        places.add(Place.of(instance, all));
      }
    }
    List<Long> costs = Arrays.stream(triangles).boxed().toList();
    return new MeasuredObject(List.copyOf(instances), costs, places, nested[0]);
  }

  /**
   * Returns whether this is still true of an object.
   *
   * @param now the instances of its Switch
   * @param structure the version of the tree's structure when this was measured
   */
  boolean holds(List<Instance> now, int versions, long structure) {
    boolean same = now.size() == instances.size() && versions == costs.size();
    for (int place = 0; same && place < now.size(); place++) {
      same =
          now.get(place) == instances.get(place)
              && ((GroupInstance) now.get(place)).restructured() <= structure;
    }
    return same;
  }
}
