package org.selectiverenderer.radiosity.trace;

import org.selectiverenderer.geometry.tree.BoxTree;
import org.selectiverenderer.geometry.tree.BoxTreeBuilder;

/**
 * A bounding-volume hierarchy over some triangles of a scene, laid out for many rays: corner and
 * edges of the triangles lie in the order of the leaves. Immutable; for several threads.
 */
final class TriangleTree {
  /** How far beyond an edge a ray still hits, so that none slips between two triangles. */
  private static final double EDGE = 1e-7;

  /**
   * Surfaces this share of the tree's extent apart touch: of a solid that a ray leaves and one that
   * it enters there, it meets the first, so that what starts inside of something is known to.
   */
  private static final double TOUCH = 1e-6;

  /** Light below this share counts as none. */
  private static final double DARK = 0.01;

  private final int[] ids;
  private final float[] boxes;
  private final int[] first;
  private final int[] count;
  private final float[] data;
  private final SceneTriangles triangles;
  private final int[] objectOf;
  private final double touch;

  /**
   * @param members the triangles in the tree
   * @param objectOf object by version
   */
  TriangleTree(SceneTriangles triangles, int[] members, int[] objectOf) {
    this.triangles = triangles;
    this.objectOf = objectOf;
    float[] corners = triangles.corners();
    BoxTree tree =
        BoxTreeBuilder.build(
            members.length,
            (item, box) -> {
              int at = 9 * members[item];
              for (int axis = 0; axis < 3; axis++) {
                float a = corners[at + axis];
                float b = corners[at + 3 + axis];
                float c = corners[at + 6 + axis];
                box[axis] = Math.min(a, Math.min(b, c));
                box[axis + 3] = Math.max(a, Math.max(b, c));
              }
            });
    boxes = tree.boxes();
    touch = members.length == 0 ? 0 : TOUCH * extent(boxes);
    first = tree.first();
    count = tree.count();
    int[] order = tree.order();
    ids = new int[order.length];
    data = new float[9 * order.length];
    for (int i = 0; i < order.length; i++) {
      ids[i] = members[order[i]];
      System.arraycopy(corners, 9 * ids[i], data, 9 * i, 9);
    }
  }

  private static double extent(float[] boxes) {
    double extent = 0;
    for (int axis = 0; axis < 3; axis++) {
      extent = Math.max(extent, (double) boxes[axis + 3] - boxes[axis]);
    }
    return extent;
  }

  /**
   * Finds what a ray meets first, if that is nearer than {@code ray.length}.
   *
   * @param without an object whose triangles are passed; 0 for none
   */
  void nearest(Ray ray, int without) {
    walk(ray, without, false);
  }

  /** How much light passes along a ray up to its length; objects as in {@link #nearest}. */
  double transmittance(Ray ray, int without) {
    return walk(ray, without, true);
  }

  private double walk(Ray ray, int without, boolean shadow) {
    if (ids.length == 0) {
      return 1;
    }
    if (shadow && ray.blockerTree == this && through(ray.blocker, ray, without) == 0) {
      return 0;
    }
    int[] stack = ray.stack;
    double[] entered = ray.entered;
    double ox = ray.ox;
    double oy = ray.oy;
    double oz = ray.oz;
    double ix = 1 / ray.dx;
    double iy = 1 / ray.dy;
    double iz = 1 / ray.dz;
    double most = ray.length + touch;
    double light = 1;
    int size = 1;
    stack[0] = 0;
    entered[0] = enter(0, ox, oy, oz, ix, iy, iz, most);
    while (size > 0) {
      int node = stack[--size];
      if (!(entered[size] <= most)) {
        continue;
      }
      int items = count[node];
      // Down to the nearest leaf; what is farther waits.
      while (items == 0) {
        int near = first[node];
        int far = near + 1;
        double toNear = enter(6 * near, ox, oy, oz, ix, iy, iz, most);
        double toFar = enter(6 * far, ox, oy, oz, ix, iy, iz, most);
        if (toFar < toNear) {
          near = far;
          far = first[node];
          double swap = toNear;
          toNear = toFar;
          toFar = swap;
        }
        if (toNear <= most) {
          if (toFar <= most) {
            entered[size] = toFar;
            stack[size++] = far;
          }
          node = near;
        } else if (toFar <= most) {
          node = far;
        } else {
          break;
        }
        items = count[node];
      }
      for (int i = first[node]; i < first[node] + items; i++) {
        if (shadow) {
          double passed = through(i, ray, without);
          light *= passed;
          if (light < DARK) {
            if (passed == 0) {
              ray.blocker = i;
              ray.blockerTree = this;
            }
            return 0;
          }
        } else {
          test(i, ray, without);
          most = ray.length + touch;
        }
      }
    }
    return light;
  }

  /** Where a ray enters a node's box (Kay and Kajiya 1986); NaN when it misses. */
  private double enter(
      int at, double ox, double oy, double oz, double ix, double iy, double iz, double most) {
    double x0 = (boxes[at] - ox) * ix;
    double x1 = (boxes[at + 3] - ox) * ix;
    double y0 = (boxes[at + 1] - oy) * iy;
    double y1 = (boxes[at + 4] - oy) * iy;
    double z0 = (boxes[at + 2] - oz) * iz;
    double z1 = (boxes[at + 5] - oz) * iz;
    double from = 0;
    double to = most;
    // Comparisons, not Math.min: a ray parallel to a slab and on its border gives NaN, which
    // they pass over.
    double low = x0 < x1 ? x0 : x1;
    double high = x0 < x1 ? x1 : x0;
    from = low > from ? low : from;
    to = high < to ? high : to;
    low = y0 < y1 ? y0 : y1;
    high = y0 < y1 ? y1 : y0;
    from = low > from ? low : from;
    to = high < to ? high : to;
    low = z0 < z1 ? z0 : z1;
    high = z0 < z1 ? z1 : z0;
    from = low > from ? low : from;
    to = high < to ? high : to;
    return from <= to * (1 + 1e-12) ? from : Double.NaN;
  }

  private double through(int item, Ray ray, int without) {
    double before = ray.length;
    int met = ray.triangle;
    test(item, ray, without);
    if (ray.length == before && ray.triangle == met) {
      return 1;
    }
    ray.length = before;
    double passed = triangles.transmittance()[ray.triangle];
    ray.triangle = met;
    return passed;
  }

  /** Möller and Trumbore 1997, in double precision. */
  private void test(int item, Ray ray, int without) {
    int at = 9 * item;
    double ax = data[at];
    double ay = data[at + 1];
    double az = data[at + 2];
    double bx = data[at + 3] - ax;
    double by = data[at + 4] - ay;
    double bz = data[at + 5] - az;
    double cx = data[at + 6] - ax;
    double cy = data[at + 7] - ay;
    double cz = data[at + 8] - az;
    double px = ray.dy * cz - ray.dz * cy;
    double py = ray.dz * cx - ray.dx * cz;
    double pz = ray.dx * cy - ray.dy * cx;
    double facing = bx * px + by * py + bz * pz;
    if (facing == 0) {
      return;
    }
    double scale = 1 / facing;
    double sx = ray.ox - ax;
    double sy = ray.oy - ay;
    double sz = ray.oz - az;
    double u = (sx * px + sy * py + sz * pz) * scale;
    if (u < -EDGE || u > 1 + EDGE) {
      return;
    }
    double qx = sy * bz - sz * by;
    double qy = sz * bx - sx * bz;
    double qz = sx * by - sy * bx;
    double v = (ray.dx * qx + ray.dy * qy + ray.dz * qz) * scale;
    if (v < -EDGE || u + v > 1 + EDGE) {
      return;
    }
    double distance = (cx * qx + cy * qy + cz * qz) * scale;
    int id = ids[item];
    if (!(distance > 0 && comesFirst(distance, id, facing < 0, ray))) {
      return;
    }
    if (without != 0 && objectOf[triangles.version()[id]] == without) {
      return;
    }
    if (triangles.transmittance()[id] > ray.pass) {
      return;
    }
    ray.length = distance;
    ray.triangle = id;
    ray.u = u;
    ray.v = v;
    ray.behind = facing < 0;
  }

  private boolean comesFirst(double distance, int id, boolean behind, Ray ray) {
    if (ray.triangle == Ray.NOTHING || Math.abs(distance - ray.length) > touch) {
      return distance < ray.length;
    }
    boolean leaves = behind && !triangles.twoSided()[id];
    boolean left = ray.behind && !triangles.twoSided()[ray.triangle];
    return leaves == left ? distance < ray.length : leaves;
  }
}
