package org.selectiverenderer.radiosity.trace;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.tree.BoxTree;

/** A ray on its way, used again and again by one thread: nothing is allocated per ray. */
public final class Ray {
  /** Nothing was met. */
  public static final int NOTHING = -1;

  public double ox;
  public double oy;
  public double oz;
  public double dx;
  public double dy;
  public double dz;

  /**
   * How far it reaches, in lengths of its direction; where it has met something, how far that is.
   */
  public double length;

  /**
   * From 0 to 1: triangles that let through more light than this are passed, so that rays with
   * evenly spread values together see a pane as transparent as it is.
   */
  public double pass;

  /** The triangle met first, or {@link #NOTHING}. */
  public int triangle;

  /** Weights of the triangle's second and third corner. */
  public double u;

  public double v;

  /** Whether the triangle was met from behind. */
  public boolean behind;

  /** Boxes that wait for the ray: links of a tree. */
  final int[] stack = new int[BoxTree.MAX_DEPTH];

  /** Per entry of the stack: where the ray enters its box, as the bits of a float. */
  final int[] entered = new int[BoxTree.MAX_DEPTH];

  /** What last stopped a shadow ray: the next one often meets it, too. An item of a tree. */
  int blocker;

  @Nullable TriangleTree blockerTree;

  /** Rays cast since it was made, for figures. */
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
