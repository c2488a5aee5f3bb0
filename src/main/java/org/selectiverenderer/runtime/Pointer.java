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
 * @param aspect width of the picture that it points into, to its height
 */
public record Pointer(Optional<Vector3dc> direction, boolean pressed, double aspect) {
  /** Over nothing. */
  public static final Pointer AWAY = new Pointer(Optional.empty(), false);

  /** In a picture as wide as high. */
  public Pointer(Optional<Vector3dc> direction, boolean pressed) {
    this(direction, pressed, 1);
  }

  public Pointer {
    if (direction.isPresent()) {
      direction = Optional.of(new Vector3d(direction.get()));
    }
  }
}
