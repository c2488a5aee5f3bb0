package org.selectiverenderer.browser.nodes.picking;

import java.util.List;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/**
 * A shape that a pick sensor has picked.
 *
 * @param node the Shape; for a shape inside an Inline, the Inline
 * @param distance the distance by which picked shapes are sorted
 * @param places the intersection points, in the sensor's local coordinates; empty if they are not
 *     needed
 */
public record PickResult(Node node, double distance, List<Place> places) {
  /**
   * An intersection point with a shape.
   *
   * @param normal the unit surface normal; null if no surface was hit
   * @param texCoord the texture coordinates s, t, 0; null if the surface has none
   */
  public record Place(Vector3dc point, @Nullable Vector3dc normal, @Nullable Vector3dc texCoord) {}
}
