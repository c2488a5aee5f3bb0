package org.selectiverenderer.runtime.nodes.drag;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** What a pointer is followed along during one drag. All in the sensor's local coordinates. */
interface DragSurface {
  /** The point on it that a ray points at; empty where it points at none. */
  Optional<Vector3d> follow(DragRay ray);

  /** The value to send for a point; called once for each point, in their order. */
  Object value(Vector3dc point);

  /** The {@code offset} from which another drag goes on where this one ended. */
  Object offset();
}
