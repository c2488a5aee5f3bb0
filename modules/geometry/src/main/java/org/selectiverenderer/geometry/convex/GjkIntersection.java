package org.selectiverenderer.geometry.convex;

import org.joml.Vector3d;

/**
 * Tests whether two convex bodies intersect, by the algorithm of Gilbert, Johnson and Keerthi (GJK,
 * 1988): they do if their Minkowski difference contains the origin, for which a simplex of support
 * points is searched (cases as in Ericson 2005, 9.5). Touching bodies intersect.
 */
public final class GjkIntersection {
  /** Iterations after which the origin is on the boundary within numerical precision. */
  private static final int STEPS = 64;

  /** The tolerance, relative to the size of the bodies. */
  private static final double NOTHING = 1e-12;

  private final ConvexShape one;
  private final ConvexShape two;
  private final Vector3d[] corners = {
    new Vector3d(), new Vector3d(), new Vector3d(), new Vector3d()
  };
  private int size;
  private final Vector3d direction = new Vector3d(1, 0, 0);

  private GjkIntersection(ConvexShape one, ConvexShape two) {
    this.one = one;
    this.two = two;
  }

  /** Returns whether two bodies intersect or touch. */
  public static boolean of(ConvexShape one, ConvexShape two) {
    return new GjkIntersection(one, two).found();
  }

  private boolean found() {
    add();
    double scale = corners[0].length();
    direction.set(corners[0]).negate();
    for (int step = 0; step < STEPS; step++) {
      double tiny = NOTHING * scale;
      if (direction.lengthSquared() <= tiny * tiny) {
        return true;
      }
      direction.normalize();
      add();
      Vector3d newest = corners[size - 1];
      scale = Math.max(scale, newest.length());
      if (newest.dot(direction) < -NOTHING * scale) {
        return false;
      }
      if (closeIn()) {
        return true;
      }
    }
    return true;
  }

  private void add() {
    Vector3d other = two.farthest(direction.negate(new Vector3d()), new Vector3d());
    one.farthest(direction, corners[size]).sub(other);
    size++;
  }

  /** Reduces the simplex to its part nearest the origin; returns whether it contains the origin. */
  private boolean closeIn() {
    return switch (size) {
      case 2 -> edge(corners[1], corners[0]);
      case 3 -> face(corners[2], corners[1], corners[0]);
      default -> solid();
    };
  }

  private void keep(Vector3d... kept) {
    Vector3d[] copies = new Vector3d[kept.length];
    for (int i = 0; i < kept.length; i++) {
      copies[i] = new Vector3d(kept[i]);
    }
    for (int i = 0; i < copies.length; i++) {
      corners[i].set(copies[i]);
    }
    size = copies.length;
  }

  private boolean edge(Vector3d a, Vector3d b) {
    Vector3d ab = b.sub(a, new Vector3d());
    Vector3d toOrigin = a.negate(new Vector3d());
    if (ab.dot(toOrigin) > 0) {
      ab.cross(toOrigin, direction).cross(ab);
      keep(b, a);
    } else {
      direction.set(toOrigin);
      keep(a);
    }
    return false;
  }

  private boolean face(Vector3d a, Vector3d b, Vector3d c) {
    Vector3d ab = b.sub(a, new Vector3d());
    Vector3d ac = c.sub(a, new Vector3d());
    Vector3d toOrigin = a.negate(new Vector3d());
    Vector3d normal = ab.cross(ac, new Vector3d());
    if (normal.cross(ac, new Vector3d()).dot(toOrigin) > 0) {
      return ac.dot(toOrigin) > 0 ? edge(a, c) : edge(a, b);
    }
    if (ab.cross(normal, new Vector3d()).dot(toOrigin) > 0) {
      return edge(a, b);
    }
    if (normal.lengthSquared() == 0) {
      return edge(a, b); // the three points are collinear
    }
    double side = normal.dot(toOrigin);
    if (side == 0) {
      return true;
    }
    if (side > 0) {
      direction.set(normal);
      keep(c, b, a);
    } else {
      direction.set(normal).negate();
      keep(b, c, a);
    }
    return false;
  }

  private boolean solid() {
    Vector3d a = new Vector3d(corners[3]);
    Vector3d b = new Vector3d(corners[2]);
    Vector3d c = new Vector3d(corners[1]);
    Vector3d d = new Vector3d(corners[0]);
    if (beyond(a, b, c)) {
      return face(a, b, c);
    }
    if (beyond(a, c, d)) {
      return face(a, c, d);
    }
    if (beyond(a, d, b)) {
      return face(a, d, b);
    }
    return true;
  }

  /** Returns whether the origin is on the outer side of a face through the newest vertex. */
  private static boolean beyond(Vector3d a, Vector3d b, Vector3d c) {
    Vector3d normal = b.sub(a, new Vector3d()).cross(c.sub(a, new Vector3d()));
    return normal.dot(a) < 0;
  }
}
