package org.selectiverenderer.runtime.nodes.pick;

import java.util.List;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;

/**
 * A shape that a sensor has picked.
 *
 * @param node the Shape; of one in an Inline, the Inline
 * @param distance by which picked shapes are sorted
 * @param places where it was met, in the sensor's local coordinates; empty where that is not asked
 */
public record Picked(Node node, double distance, List<Place> places) {
  /**
   * Where a shape was met.
   *
   * @param normal of the surface, of unit length; null where no surface was met
   * @param texCoord s, t, 0; null where the surface has none
   */
  public record Place(Vector3dc point, @Nullable Vector3dc normal, @Nullable Vector3dc texCoord) {}
}
