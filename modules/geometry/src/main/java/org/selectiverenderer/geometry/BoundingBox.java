package org.selectiverenderer.geometry;

import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** An axis-aligned bounding box; empty if a minimum is above its maximum. */
public record BoundingBox(
    double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
  /** The empty box. */
  public static final BoundingBox EMPTY =
      of(new Vector3d(Double.POSITIVE_INFINITY), new Vector3d(Double.NEGATIVE_INFINITY));

  /** Returns the box between two corners. */
  public static BoundingBox of(Vector3dc min, Vector3dc max) {
    return new BoundingBox(min.x(), min.y(), min.z(), max.x(), max.y(), max.z());
  }

  /** Returns the box of min x, y, z, max x, y, z. */
  public static BoundingBox of(float[] b) {
    return new BoundingBox(b[0], b[1], b[2], b[3], b[4], b[5]);
  }

  /** Returns the box of min x, y, z, max x, y, z. */
  public static BoundingBox of(double[] b) {
    return new BoundingBox(b[0], b[1], b[2], b[3], b[4], b[5]);
  }

  /** Returns the smallest box around points, given as x, y, z each. */
  public static BoundingBox around(float[] points) {
    double[] b = EMPTY.toArray();
    for (int i = 0; i < points.length; i++) {
      b[i % 3] = Math.min(b[i % 3], points[i]);
      b[3 + i % 3] = Math.max(b[3 + i % 3], points[i]);
    }
    return of(b);
  }

  /** Returns min x, y, z, max x, y, z. */
  public double[] toArray() {
    return new double[] {minX, minY, minZ, maxX, maxY, maxZ};
  }

  /** Returns the corner with the least coordinates. */
  public Vector3d min() {
    return new Vector3d(minX, minY, minZ);
  }

  /** Returns the corner with the greatest coordinates. */
  public Vector3d max() {
    return new Vector3d(maxX, maxY, maxZ);
  }

  /** Returns a corner, 0 to 7: bit 0 stands for the larger x, bit 1 for y, bit 2 for z. */
  public Vector3d corner(int number) {
    return new Vector3d(
        (number & 1) == 0 ? minX : maxX,
        (number & 2) == 0 ? minY : maxY,
        (number & 4) == 0 ? minZ : maxZ);
  }

  /** Returns the extent along x. */
  public double width() {
    return maxX - minX;
  }

  /** Returns the extent along y. */
  public double height() {
    return maxY - minY;
  }

  /** Returns the extent along z. */
  public double depth() {
    return maxZ - minZ;
  }

  /** Returns the length of the longest side. */
  public double extent() {
    return Math.max(width(), Math.max(height(), depth()));
  }

  /** Returns the volume; 0 if the box is empty. */
  public double volume() {
    return isEmpty() ? 0 : width() * height() * depth();
  }

  /** Returns whether the box contains no point. */
  public boolean isEmpty() {
    return !(minX <= maxX && minY <= maxY && minZ <= maxZ);
  }

  /** Returns the smallest box around both. */
  public BoundingBox union(BoundingBox other) {
    return isEmpty()
        ? other
        : other.isEmpty()
            ? this
            : new BoundingBox(
                Math.min(minX, other.minX),
                Math.min(minY, other.minY),
                Math.min(minZ, other.minZ),
                Math.max(maxX, other.maxX),
                Math.max(maxY, other.maxY),
                Math.max(maxZ, other.maxZ));
  }

  /** Returns the box expanded by a margin on all sides. */
  public BoundingBox grown(double margin) {
    return of(min().sub(margin, margin, margin), max().add(margin, margin, margin));
  }

  /** Returns the axis-aligned box around the transformed box; not tight under rotation. */
  public BoundingBox transformed(Matrix4dc matrix) {
    if (isEmpty()) {
      return this;
    }
    Vector3d min = new Vector3d();
    Vector3d max = new Vector3d();
    matrix.transformAab(min(), max(), min, max);
    return of(min, max);
  }

  /** Returns whether a point is in the box or on its surface. */
  public boolean contains(Vector3dc p) {
    return p.x() >= minX
        && p.y() >= minY
        && p.z() >= minZ
        && p.x() <= maxX
        && p.y() <= maxY
        && p.z() <= maxZ;
  }

  /** Returns whether the boxes have no point in common. */
  public boolean apart(BoundingBox other) {
    return Math.max(minX, other.minX) > Math.min(maxX, other.maxX)
        || Math.max(minY, other.minY) > Math.min(maxY, other.maxY)
        || Math.max(minZ, other.minZ) > Math.min(maxZ, other.maxZ);
  }
}
