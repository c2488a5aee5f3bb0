package org.selectiverenderer.radiosity.trace;

import org.selectiverenderer.geometry.bvh.Bvh;

/**
 * A bounding volume hierarchy over some triangles of a scene for many rays: the corners of the
 * triangles are copied in the order of the leaves. Immutable; for several threads.
 */
final class TriangleBvh {
  /**
   * Tolerance beyond an edge within which a ray still hits, so that none slips between two
   * triangles; in barycentric weights.
   */
  private static final double EDGE = 1e-7;

  /**
   * Distance, as a share of the tree's extent, within which two surfaces touch: where a ray leaves
   * a solid and enters another, it hits the back of the first, so that rays which start inside of a
   * solid are recognized.
   */
  private static final double TOUCH = 1e-6;

  /** Transmitted share of light below which it counts as none. */
  private static final double DARK = 0.01;

  /** Least absolute component of a direction. */
  private static final double FLAT = 1e-30;

  /**
   * Number of floats by which two equal distances may differ: each is the result of three
   * operations and so within three of the exact value.
   */
  private static final int SLACK = 8;

  private final int[] ids;
  private final CompactBvh pairs;
  private final float[] data;
  private final SceneTriangles triangles;
  private final int[] objectOf;
  private final double touch;

  /**
   * @param members the triangles in the tree
   * @param objectOf object by version
   */
  TriangleBvh(SceneTriangles triangles, int[] members, int[] objectOf) {
    this.triangles = triangles;
    this.objectOf = objectOf;
    Bvh tree = triangles.tree(members);
    pairs = CompactBvh.of(tree);
    touch = members.length == 0 ? 0 : TOUCH * extent(tree.boxes());
    int[] order = tree.order();
    ids = new int[order.length];
    data = new float[9 * order.length];
    for (int i = 0; i < order.length; i++) {
      ids[i] = members[order[i]];
      System.arraycopy(triangles.corners(), 9 * ids[i], data, 9 * i, 9);
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
   * Finds the first hit of a ray, if it is nearer than {@code ray.length}.
   *
   * @param without an object whose triangles are ignored; 0 for none
   */
  void nearest(Ray ray, int without) {
    walk(ray, without, false);
  }

  /**
   * Returns the share of light that passes along a ray up to its length; {@code without} as in
   * {@link #nearest}.
   */
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
    float[] nodes = pairs.nodes();
    int[] stack = ray.stack;
    int[] entered = ray.entered;
    float ix = inverse(ray.dx);
    float iy = inverse(ray.dy);
    float iz = inverse(ray.dz);
    // Offsets of the box planes that the ray meets first, and last.
    int nearX = ix < 0 ? 3 : 0;
    int nearY = iy < 0 ? 4 : 1;
    int nearZ = iz < 0 ? 5 : 2;
    int farX = 3 - nearX;
    int farY = 5 - nearY;
    int farZ = 7 - nearZ;
    // Rounded so that the ray enters boxes too early and leaves them too late.
    float nearOx = above(ray.ox, ix);
    float nearOy = above(ray.oy, iy);
    float nearOz = above(ray.oz, iz);
    float farOx = above(ray.ox, -ix);
    float farOy = above(ray.oy, -iy);
    float farOz = above(ray.oz, -iz);
    int most = reach(ray);
    double light = 1;
    int size = 0;
    int link = pairs.root();
    while (true) {
      // Descends to the nearest leaf; the farther child is pushed (Kay and Kajiya 1986).
      while (link >= 0) {
        int right = link + CompactBvh.RIGHT;
        int toLeft =
            latest(
                (nodes[link + nearX] - nearOx) * ix,
                (nodes[link + nearY] - nearOy) * iy,
                (nodes[link + nearZ] - nearOz) * iz);
        int endLeft =
            soonest(
                (nodes[link + farX] - farOx) * ix,
                (nodes[link + farY] - farOy) * iy,
                (nodes[link + farZ] - farOz) * iz,
                most);
        int toRight =
            latest(
                (nodes[right + nearX] - nearOx) * ix,
                (nodes[right + nearY] - nearOy) * iy,
                (nodes[right + nearZ] - nearOz) * iz);
        int endRight =
            soonest(
                (nodes[right + farX] - farOx) * ix,
                (nodes[right + farY] - farOy) * iy,
                (nodes[right + farZ] - farOz) * iz,
                most);
        int leftLink = Float.floatToRawIntBits(nodes[link + CompactBvh.LINK]);
        int rightLink = Float.floatToRawIntBits(nodes[link + CompactBvh.LINK + 1]);
        if (toLeft <= endLeft + SLACK) {
          if (toRight <= endRight + SLACK) {
            boolean leftFirst = toLeft <= toRight;
            stack[size] = leftFirst ? rightLink : leftLink;
            entered[size++] = Math.max(toLeft, toRight);
            link = leftFirst ? leftLink : rightLink;
          } else {
            link = leftLink;
          }
        } else if (toRight <= endRight + SLACK) {
          link = rightLink;
        } else {
          link = CompactBvh.LEAF; // One without items.
        }
      }
      for (int i = CompactBvh.first(link); i < CompactBvh.end(link); i++) {
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
        } else if (test(i, ray, without)) {
          most = reach(ray);
        }
      }
      do {
        if (size == 0) {
          return light;
        }
        link = stack[--size];
      } while (entered[size] > most + SLACK);
    }
  }

  /**
   * Returns the inverse of a component of a direction; never infinite, so that no product is NaN.
   */
  private static float inverse(double component) {
    return Math.abs(component) < FLAT
        ? (float) Math.copySign(1 / FLAT, component)
        : (float) (1 / component);
  }

  /** Rounds a coordinate to a float: up if the ray ascends along the axis, else down. */
  private static float above(double coordinate, float up) {
    return up < 0 ? Math.nextDown((float) coordinate) : Math.nextUp((float) coordinate);
  }

  /** Returns the largest distance of boxes, as the bits of a float. */
  private int reach(Ray ray) {
    return Float.floatToRawIntBits((float) (ray.length + touch));
  }

  /**
   * Returns the largest of three distances and 0, as the bits of a float. As integers, the bits of
   * positive floats are in the floats' order and those of negative floats are below them, so that
   * they are compared without a branch.
   */
  private static int latest(float x, float y, float z) {
    return Math.max(
        Math.max(Float.floatToRawIntBits(x), Float.floatToRawIntBits(y)),
        Math.max(Float.floatToRawIntBits(z), 0));
  }

  /**
   * Returns the least of three distances and a fourth given as bits, as the bits of a float; below
   * 0 if one of them is.
   */
  private static int soonest(float x, float y, float z, int most) {
    return Math.min(
        Math.min(Float.floatToRawIntBits(x), Float.floatToRawIntBits(y)),
        Math.min(Float.floatToRawIntBits(z), most));
  }

  private double through(int item, Ray ray, int without) {
    double before = ray.length;
    int met = ray.triangle;
    if (!test(item, ray, without)) {
      return 1;
    }
    ray.length = before;
    double passed = triangles.transmittance()[ray.triangle];
    ray.triangle = met;
    return passed;
  }

  /**
   * Tests whether a triangle is the first hit of a ray so far (Möller and Trumbore 1997, in double
   * precision).
   */
  private boolean test(int item, Ray ray, int without) {
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
      return false;
    }
    double scale = 1 / facing;
    double sx = ray.ox - ax;
    double sy = ray.oy - ay;
    double sz = ray.oz - az;
    double u = (sx * px + sy * py + sz * pz) * scale;
    if (u < -EDGE || u > 1 + EDGE) {
      return false;
    }
    double qx = sy * bz - sz * by;
    double qy = sz * bx - sx * bz;
    double qz = sx * by - sy * bx;
    double v = (ray.dx * qx + ray.dy * qy + ray.dz * qz) * scale;
    if (v < -EDGE || u + v > 1 + EDGE) {
      return false;
    }
    double distance = (cx * qx + cy * qy + cz * qz) * scale;
    int id = ids[item];
    if (!(distance > 0 && comesFirst(distance, id, facing < 0, ray))) {
      return false;
    }
    if (without != 0 && objectOf[triangles.version()[id]] == without) {
      return false;
    }
    if (triangles.transmittance()[id] > ray.pass) {
      return false;
    }
    ray.length = distance;
    ray.triangle = id;
    ray.u = u;
    ray.v = v;
    ray.behind = facing < 0;
    return true;
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
