package org.selectiverenderer.document.area;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.geometry.Bounds;

/**
 * The box of an area as its author thinks of it: in the scene's frame and unit, Y up.
 *
 * @param centre in the scene
 * @param size along X, Y and Z; of a turned area along its own sides nearest to these. Above 0
 */
public record AreaBox(Vector3dc centre, Vector3dc size) {
  public AreaBox {
    centre = new Vector3d(centre);
    size = new Vector3d(size);
  }

  /** The box of bounds. */
  public static AreaBox of(Bounds bounds) {
    return new AreaBox(bounds.min().add(bounds.max()).mul(0.5), bounds.max().sub(bounds.min()));
  }

  /** The bounds of the box, if it is not turned. */
  public Bounds bounds() {
    Vector3d half = new Vector3d(size).mul(0.5);
    return Bounds.of(centre.sub(half, new Vector3d()), centre.add(half, new Vector3d()));
  }

  /** The same box elsewhere. */
  public AreaBox movedBy(Vector3dc shift) {
    return new AreaBox(centre.add(shift, new Vector3d()), size);
  }

  /** Whether it has an inside that can be written. */
  public boolean sound() {
    return centre.isFinite() && size.isFinite() && size.x() > 0 && size.y() > 0 && size.z() > 0;
  }
}
