package org.selectiverenderer.authoring.area;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * The box of an area in the coordinates and the unit of the scene, Y up.
 *
 * @param centre centre in scene coordinates
 * @param size size along X, Y and Z, above 0; for a rotated area along its own axes nearest to
 *     these
 */
public record AreaBox(Vector3dc centre, Vector3dc size) {
  public AreaBox {
    centre = new Vector3d(centre);
    size = new Vector3d(size);
  }

  /** Creates the box of a bounding box. */
  public static AreaBox of(BoundingBox bounds) {
    return new AreaBox(bounds.min().add(bounds.max()).mul(0.5), bounds.max().sub(bounds.min()));
  }

  /** Returns the bounding box, if the box is not rotated. */
  public BoundingBox bounds() {
    Vector3d half = new Vector3d(size).mul(0.5);
    return BoundingBox.of(centre.sub(half, new Vector3d()), centre.add(half, new Vector3d()));
  }

  /** Returns the box translated by a vector. */
  public AreaBox movedBy(Vector3dc shift) {
    return new AreaBox(centre.add(shift, new Vector3d()), size);
  }

  /** Returns whether centre and size are finite and the size is positive. */
  public boolean sound() {
    return centre.isFinite() && size.isFinite() && size.x() > 0 && size.y() > 0 && size.z() > 0;
  }
}
