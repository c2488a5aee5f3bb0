package org.selectiverenderer.radiosity.trace;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.bvh.Bvh;

/** A ray with its hit. Reused by one thread, so that nothing is allocated per ray. */
public final class Ray {
  /** The triangle of a ray that hit nothing. */
  public static final int NOTHING = -1;

  public double ox;
  public double oy;
  public double oz;
  public double dx;
  public double dy;
  public double dz;

  /** Length of the ray, in lengths of its direction; after a hit, the distance of the hit. */
  public double length;

  /**
   * From 0 to 1: the ray passes triangles with a larger transmittance, so that rays with evenly
   * distributed values together see a pane with its transmittance.
   */
  public double pass;

  /** The triangle hit first, or {@link #NOTHING}. */
  public int triangle;

  /** Barycentric weights of the triangle's second and third corner at the hit. */
  public double u;

  public double v;

  /** Whether the triangle was hit from behind. */
  public boolean behind;

  /** Traversal stack: links of a tree. */
  final int[] stack = new int[Bvh.MAX_DEPTH];

  /**
   * Per entry of the stack: the distance at which the ray enters the box, as the bits of a float.
   */
  final int[] entered = new int[Bvh.MAX_DEPTH];

  /** The item of a tree that stopped the last shadow ray, which often stops the next one, too. */
  int blocker;

  @Nullable TriangleBvh blockerTree;

  /** Number of rays cast with this object, for statistics. */
  long cast;

  public void from(double[] point, double[] direction) {
    ox = point[0];
    oy = point[1];
    oz = point[2];
    dx = direction[0];
    dy = direction[1];
    dz = direction[2];
  }

  public void from(Vector3d point, Vector3d direction) {
    ox = point.x;
    oy = point.y;
    oz = point.z;
    dx = direction.x;
    dy = direction.y;
    dz = direction.z;
  }

  public long cast() {
    return cast;
  }
}
