package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * Computes the spine-aligned cross-section planes of an Extrusion (X3D 4.0, 13.3.5.3 and 13.3.5.4):
 * at each spine point an orthonormal frame with Y along the spine, Z normal to the plane of its
 * bend, and X = Y x Z.
 */
final class SpineFrames {
  private final Vector3d[] spine;
  private final int count;
  private final boolean closed;
  private final Vector3d[] y;
  private final Vector3d[] z;
  private final int[] frameOf;

  /**
   * Computes the frames.
   *
   * @param points x, y, z per spine point, finite, at least one
   */
  SpineFrames(float[] points) {
    int given = points.length / 3;
    Vector3d[] distinct = new Vector3d[given];
    this.frameOf = new int[given];
    int last = -1;
    for (int i = 0; i < given; i++) {
      Vector3d point = new Vector3d(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
      // coincident neighbours share a plane
      if (last < 0 || !distinct[last].equals(point)) {
        distinct[++last] = point;
      }
      frameOf[i] = last;
    }
    this.count = last + 1;
    this.spine = Arrays.copyOf(distinct, count);
    this.closed = count > 2 && spine[0].equals(spine[count - 1]);
    this.y = new Vector3d[count];
    this.z = new Vector3d[count];
    for (int i = 0; i < count; i++) {
      y[i] = along(i);
      z[i] = bend(i);
    }
    Vector3d firstBend = firstBend();
    if (firstBend == null) {
      straight();
    } else {
      fillIn(firstBend);
    }
  }

  Vector3d xAxis(int point) {
    return yAxis(point).cross(zAxis(point), new Vector3d());
  }

  Vector3d yAxis(int point) {
    return y[frameOf[point]];
  }

  Vector3d zAxis(int point) {
    return z[frameOf[point]];
  }

  private Vector3d along(int i) {
    Vector3d direction = new Vector3d();
    if (count > 1) {
      spine[next(i)].sub(spine[previous(i)], direction);
      if (direction.lengthSquared() == 0) {
        // the spine reverses its direction here
        spine[next(i)].sub(spine[i], direction);
      }
    }
    return direction.lengthSquared() == 0 ? new Vector3d(0, 1, 0) : direction.normalize();
  }

  private int next(int i) {
    return i + 1 < count ? i + 1 : closed ? 1 : i;
  }

  private int previous(int i) {
    return i > 0 ? i - 1 : closed ? count - 2 : i;
  }

  /** Returns the unit normal of the bend at a point; zero where the spine is straight or ends. */
  private Vector3d bend(int i) {
    Vector3d ahead = spine[next(i)].sub(spine[i], new Vector3d());
    Vector3d behind = spine[previous(i)].sub(spine[i], new Vector3d());
    Vector3d normal = ahead.cross(behind, new Vector3d());
    double straightness = 1e-12 * ahead.lengthSquared() * behind.lengthSquared();
    return normal.lengthSquared() <= straightness ? new Vector3d() : normal.normalize();
  }

  /** Returns the first Z axis that is defined; null if the spine is straight. */
  private @Nullable Vector3d firstBend() {
    for (Vector3d axis : z) {
      if (axis.lengthSquared() > 0) {
        return axis;
      }
    }
    return null;
  }

  /** Sets the frames of a collinear spine by the rotation from the y axis to its direction. */
  private void straight() {
    Quaterniond turn = new Quaterniond().rotationTo(new Vector3d(0, 1, 0), y[0]);
    for (int i = 0; i < count; i++) {
      if (y[i].dot(y[0]) < 0) {
        y[i].negate();
      }
      z[i] = turn.transform(new Vector3d(0, 0, 1));
    }
  }

  /** Copies undefined Z axes from the previous point, and negates axes that flip. */
  private void fillIn(Vector3d firstBend) {
    Vector3d before = firstBend;
    for (int i = 0; i < count; i++) {
      Vector3d axis = z[i].lengthSquared() == 0 ? new Vector3d(before) : z[i];
      if (axis.dot(before) < 0) {
        axis.negate();
      }
      // orthogonalize to Y, in case the axis was copied from another point
      Vector3d square = axis.sub(y[i].mul(axis.dot(y[i]), new Vector3d()), new Vector3d());
      z[i] = square.lengthSquared() < 1e-12 ? anyNormal(y[i]) : square.normalize();
      before = z[i];
    }
  }

  private static Vector3d anyNormal(Vector3d axis) {
    Vector3d other = Math.abs(axis.z) < 0.9 ? new Vector3d(0, 0, 1) : new Vector3d(1, 0, 0);
    return axis.cross(other, new Vector3d()).normalize();
  }
}
