package org.selectiverenderer.browser.nodes.drag;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The surface along which the pointer is followed during one drag. All coordinates are the sensor's
 * local ones.
 */
interface DragSurface {
  /** Returns the point of the surface on a ray; empty if there is none. */
  Optional<Vector3d> follow(DragRay ray);

  /** Returns the value to send for a point; called once for each point, in their order. */
  Object value(Vector3dc point);

  /** Returns the {@code offset} with which another drag continues where this one ended. */
  Object offset();
}
