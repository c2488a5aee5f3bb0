package org.selectiverenderer.browser.instance;

import java.util.function.Predicate;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Measures an instance as if all groups above it showed it, such as a version of an object that is
 * not shown now.
 *
 * @param triangles number of triangles that it would show, with the present choices of Switches and
 *     LODs inside
 * @param bounds their bounding box in the world; empty without geometry
 */
public record SubtreeMeasurement(long triangles, BoundingBox bounds) {
  /**
   * Measures an instance.
   *
   * @param leftOut nodes that do not count, with all below them
   */
  public static SubtreeMeasurement of(Instance instance, Predicate<Node> leftOut) {
    Sum sum = new Sum(leftOut);
    sum.add(instance);
    return new SubtreeMeasurement(sum.triangles, sum.bounds);
  }

  private static final class Sum {
    private final Predicate<Node> leftOut;
    private long triangles;
    private BoundingBox bounds = BoundingBox.EMPTY;

    Sum(Predicate<Node> leftOut) {
      this.leftOut = leftOut;
    }

    void add(Instance instance) {
      if (leftOut.test(instance.node())) {
        return;
      }
      if (instance instanceof GroupInstance group) {
        for (int i = 0; i < group.children().size(); i++) {
          if (group.node().shows(i)) {
            add(group.children().get(i));
          }
        }
      } else if (instance instanceof ShapeInstance shape && shape.look().visible()) {
        triangles += shape.look().polygons();
        bounds = bounds.union(BoundingBox.of(shape.bounds()));
      }
    }
  }
}
