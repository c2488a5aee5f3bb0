package org.selectiverenderer.browser;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The state of the pointing device at one moment.
 *
 * @param direction the pointing direction in the viewer's frame (looking along -Z, Y up), of any
 *     length; empty if the device points at nothing of the scene, for example outside the window
 * @param pressed whether the device's button is down
 * @param aspect the ratio of width to height of the picture that it points into
 */
public record PointingDeviceState(Optional<Vector3dc> direction, boolean pressed, double aspect) {
  /** The state in which the device points at nothing. */
  public static final PointingDeviceState AWAY = new PointingDeviceState(Optional.empty(), false);

  /** Makes a state for a square picture. */
  public PointingDeviceState(Optional<Vector3dc> direction, boolean pressed) {
    this(direction, pressed, 1);
  }

  public PointingDeviceState {
    if (direction.isPresent()) {
      direction = Optional.of(new Vector3d(direction.get()));
    }
  }
}
