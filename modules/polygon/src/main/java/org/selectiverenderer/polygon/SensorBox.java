package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * The box of a ProximitySensor in world coordinates. Under rotated and non-uniformly scaled
 * Transforms it is a parallelepiped: the intersection of six half-spaces.
 *
 * @param centre centre in world coordinates
 * @param sides the six bounding planes
 * @param corners all eight corners
 */
public record SensorBox(
    Vector3dc centre, List<Side> sides, List<Vector3dc> corners, BoundingBox bounds) {
  /**
   * Boxes whose overlap is thinner than this, in metres perpendicular to a side, only touch: the
   * viewer is never in both. The value is far above the rounding error of single-precision
   * coordinates.
   */
  static final double TOUCHING = 1e-5;

  /**
   * A plane.
   *
   * @param normal outward normal of length 1
   * @param distance signed distance of the plane from the origin along the normal
   */
  public record Side(Vector3dc normal, double distance) {}

  /**
   * Returns the box of one instance of a sensor.
   *
   * @param world transform from the sensor's coordinates to the world
   * @return empty if the box has no volume, so that nobody can enter it
   */
  public static Optional<SensorBox> of(float[] centre, float[] size, Matrix4dc world) {
    Matrix4d inverse = world.invert(new Matrix4d());
    if (!(size[0] > 0 && size[1] > 0 && size[2] > 0) || !inverse.isFinite()) {
      return Optional.empty();
    }
    List<Side> sides = new ArrayList<>(6);
    for (int axis = 0; axis < 3; axis++) {
      // A row of the inverse matrix gives the local coordinate on that axis as a function of a
      // world point.
      Vector3d row = new Vector3d(inverse.get(0, axis), inverse.get(1, axis), inverse.get(2, axis));
      double length = row.length();
      Vector3d normal = row.div(length);
      double middle = (centre[axis] - inverse.get(3, axis)) / length;
      double half = size[axis] / 2.0 / length;
      sides.add(new Side(normal, middle + half));
      sides.add(new Side(normal.negate(new Vector3d()), half - middle));
    }
    Vector3d min =
        new Vector3d(
            centre[0] - size[0] / 2.0, centre[1] - size[1] / 2.0, centre[2] - size[2] / 2.0);
    BoundingBox local = BoundingBox.of(min, new Vector3d(size[0], size[1], size[2]).add(min));
    Vector3d middle = world.transformPosition(new Vector3d(centre[0], centre[1], centre[2]));
    return Optional.of(
        new SensorBox(middle, List.copyOf(sides), corners(local, world), local.transformed(world)));
  }

  private static List<Vector3dc> corners(BoundingBox local, Matrix4dc world) {
    List<Vector3dc> corners = new ArrayList<>(8);
    for (int i = 0; i < 8; i++) {
      corners.add(world.transformPosition(local.corner(i)));
    }
    return List.copyOf(corners);
  }

  /** Returns whether this box contains another one; sides may touch. */
  public boolean contains(SensorBox other) {
    return other.corners.stream()
        .allMatch(
            corner ->
                sides.stream()
                    .allMatch(side -> side.normal.dot(corner) <= side.distance + TOUCHING));
  }

  /**
   * Returns whether the boxes have a common point. Their intersection is a convex polyhedron, each
   * of whose corners is where three planes meet: it is not empty if one of these points is inside
   * all planes.
   */
  public static boolean share(List<SensorBox> boxes) {
    List<Side> sides = new ArrayList<>();
    for (SensorBox box : boxes) {
      for (SensorBox other : boxes) {
        if (box.bounds.apart(other.bounds)) {
          return false;
        }
      }
      box.sides.forEach(side -> sides.add(new Side(side.normal, side.distance - TOUCHING / 2)));
    }
    for (int i = 0; i < sides.size(); i++) {
      for (int j = i + 1; j < sides.size(); j++) {
        for (int k = j + 1; k < sides.size(); k++) {
          if (meetBehindAll(sides.get(i), sides.get(j), sides.get(k), sides)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Returns whether a point is in the box or on its sides. */
  public boolean contains(Vector3dc place) {
    return sides.stream().allMatch(side -> side.normal.dot(place) <= side.distance);
  }

  private static boolean meetBehindAll(Side a, Side b, Side c, List<Side> all) {
    Vector3d bc = b.normal.cross(c.normal, new Vector3d());
    double determinant = a.normal.dot(bc);
    if (Math.abs(determinant) < 1e-12) {
      return false; // the planes do not meet in a single point
    }
    Vector3d point =
        bc.mul(a.distance)
            .add(c.normal.cross(a.normal, new Vector3d()).mul(b.distance))
            .add(a.normal.cross(b.normal, new Vector3d()).mul(c.distance))
            .div(determinant);
    for (Side side : all) {
      if (side != a
          && side != b
          && side != c
          && side.normal.dot(point) > side.distance + 1e-9 * (1 + Math.abs(side.distance))) {
        return false;
      }
    }
    return true;
  }
}
