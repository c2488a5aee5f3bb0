package org.selectiverenderer.runtime;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * What the pointing device says.
 *
 * @param direction where it points, in the viewer's frame (looking along -Z, Y up), of any length;
 *     empty when it is over nothing of the scene, outside the window for instance
 * @param pressed whether its button is down
 */
public record Pointer(Optional<Vector3dc> direction, boolean pressed) {
  /** Over nothing. */
  public static final Pointer AWAY = new Pointer(Optional.empty(), false);

  public Pointer {
    direction = direction.map(Vector3d::new);
  }
}
