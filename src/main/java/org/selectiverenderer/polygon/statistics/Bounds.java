package org.selectiverenderer.polygon.statistics;

import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** An axis-aligned box; empty when a minimum is above its maximum. */
public record Bounds(Vector3dc min, Vector3dc max) {
  /** Of nothing. */
  public static final Bounds EMPTY =
      new Bounds(new Vector3d(Double.POSITIVE_INFINITY), new Vector3d(Double.NEGATIVE_INFINITY));

  /** Of min x, y, z, max x, y, z. */
  public static Bounds of(float[] b) {
    return new Bounds(new Vector3d(b[0], b[1], b[2]), new Vector3d(b[3], b[4], b[5]));
  }

  /** Whether there is no place in it. */
  public boolean isEmpty() {
    return !(min.x() <= max.x() && min.y() <= max.y() && min.z() <= max.z());
  }

  /** The least bounds that hold both. */
  public Bounds and(Bounds other) {
    return isEmpty()
        ? other
        : other.isEmpty()
            ? this
            : new Bounds(min.min(other.min, new Vector3d()), max.max(other.max, new Vector3d()));
  }

  /** The bounds of the transformed box; larger than those of its content if that is turned. */
  public Bounds transformed(Matrix4dc matrix) {
    if (isEmpty()) {
      return this;
    }
    Vector3d newMin = new Vector3d();
    Vector3d newMax = new Vector3d();
    matrix.transformAab(min, max, newMin, newMax);
    return new Bounds(newMin, newMax);
  }

  /** Whether a place is in it or on its sides. */
  public boolean contains(Vector3dc p) {
    return p.x() >= min.x()
        && p.y() >= min.y()
        && p.z() >= min.z()
        && p.x() <= max.x()
        && p.y() <= max.y()
        && p.z() <= max.z();
  }

  double volume() {
    return isEmpty() ? 0 : (max.x() - min.x()) * (max.y() - min.y()) * (max.z() - min.z());
  }
}
