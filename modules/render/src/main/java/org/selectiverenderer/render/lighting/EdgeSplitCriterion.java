package org.selectiverenderer.render.lighting;

import java.util.Arrays;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.bvh.ClosestPoint;

/**
 * The refinement criterion: decides which edges of a mesh are too long for per-vertex lighting,
 * from the light at the edge's ends and middle, and from the angle between its normals and the size
 * of its triangle. An edge is split if one of its triangles requires it.
 */
final class EdgeSplitCriterion {
  /** The reason why an edge is to be split. */
  enum Reason {
    NONE,
    SHAPE,
    LIGHT
  }

  /**
   * Edges shorter than this share of the distance to the nearest light are not split for their
   * light.
   */
  private static final double LEAST_ANGLE = 0.04;

  /** Edges shorter than this share of the mesh's longest edge are not split either. */
  private static final double LEAST_SHARE = 1.0 / 256;

  /** A larger error at the shortest edges is a step in the light that no mesh can follow. */
  private static final double STEP = 10.0 / 255;

  private static final double NOT_KNOWN = Double.NaN;

  private final MidpointVertexBuffer vertices;
  private final CurvatureTolerance fineness;
  private final DiffuseLightModel field;
  private final double tolerance;
  private final double shortest;
  private final int sides;
  private final double[] sample;
  private final double[] straight;
  private final double[] at = new double[6];
  private final int[] corner = new int[3];
  private final double[] shares = new double[3];
  private final Vector3d[] corners = {new Vector3d(), new Vector3d(), new Vector3d()};
  private final Vector3d spot = new Vector3d();
  private double[] light = {};
  private boolean stepped;

  /**
   * @param longest edge of the mesh in the world
   * @param tolerance the invisible error of the light, in 0..1
   */
  EdgeSplitCriterion(
      MidpointVertexBuffer vertices,
      CurvatureTolerance fineness,
      DiffuseLightModel field,
      boolean twoSided,
      double longest,
      double tolerance) {
    this.vertices = vertices;
    this.fineness = fineness;
    this.field = field;
    this.tolerance = tolerance;
    shortest = longest * LEAST_SHARE;
    sides = twoSided ? 2 : 1;
    sample = new double[3 * sides];
    straight = new double[3 * sides];
  }

  /** Returns whether it met a step in the light that no mesh can follow. */
  boolean stepped() {
    return stepped;
  }

  /** Returns the length of an edge in the world. */
  double length(int a, int b) {
    double[] p = vertices.placed();
    double dx = p[6 * b] - p[6 * a];
    double dy = p[6 * b + 1] - p[6 * a + 1];
    double dz = p[6 * b + 2] - p[6 * a + 2];
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  /** Returns the square of a triangle's size. */
  double size(int a, int b, int c) {
    double ab = length(a, b);
    double bc = length(b, c);
    double ca = length(c, a);
    return MeshMetrics.size(ab * ab, bc * bc, ca * ca);
  }

  /**
   * Returns whether and why an edge is to be split.
   *
   * @param size the square of its triangle's size
   */
  Reason edge(int a, int b, double size) {
    double length = length(a, b);
    double[] p = vertices.placed();
    int i = 6 * a;
    int j = 6 * b;
    double cosine = p[i + 3] * p[j + 3] + p[i + 4] * p[j + 4] + p[i + 5] * p[j + 5];
    if (cosine < fineness.cosine() && size > fineness.bent() * fineness.bent()) {
      return Reason.SHAPE;
    }
    if (field.isEmpty() || !(length > 0)) {
      return Reason.NONE;
    }
    double x = (p[i] + p[j]) / 2;
    double y = (p[i + 1] + p[j + 1]) / 2;
    double z = (p[i + 2] + p[j + 2]) / 2;
    double nearest = field.nearest(x, y, z);
    if (field.bound(x, y, z, length) <= tolerance) {
      return Reason.NONE;
    }
    double error = departure(a, b, 0.5);
    if (length > nearest / 2) {
      error = Math.max(error, Math.max(departure(a, b, 0.25), departure(a, b, 0.75)));
    }
    return error <= tolerance ? Reason.NONE : split(length, nearest, error);
  }

  private Reason split(double length, double nearest, double error) {
    if (length > Math.max(shortest, LEAST_ANGLE * nearest)) {
      return Reason.LIGHT;
    }
    stepped |= error > STEP;
    return Reason.NONE;
  }

  /**
   * Returns whether there is light inside a triangle that its edges do not show: at the point
   * nearest to a light, or where the axis of a spot light meets it.
   */
  boolean inside(int a, int b, int c) {
    if (field.isEmpty()) {
      return false;
    }
    double longest = Math.max(length(a, b), Math.max(length(b, c), length(c, a)));
    double[] p = vertices.placed();
    spot.zero();
    for (int i = 0; i < 3; i++) {
      int v = 6 * (i == 0 ? a : i == 1 ? b : c);
      corners[i].set(p[v], p[v + 1], p[v + 2]);
      spot.fma(1.0 / 3, corners[i]);
    }
    // Every point of the triangle lies within two thirds of its longest edge from the centroid.
    if (longest <= shortest
        || field.bound(spot.x, spot.y, spot.z, longest * 4 / 3) <= 2 * tolerance) {
      return false;
    }
    if (departure(a, b, c) > 2 * tolerance) {
      return true;
    }
    for (int i = 0; i < field.size(); i++) {
      WorldSpaceLight lamp = field.light(i);
      ClosestPoint.onTriangle(corners[0], corners[1], corners[2], lamp.position(), spot);
      if (departure(a, b, c) > 2 * tolerance || beam(lamp, a, b, c)) {
        return true;
      }
    }
    return false;
  }

  private boolean beam(WorldSpaceLight lamp, int a, int b, int c) {
    Vector3d normal =
        corners[1]
            .sub(corners[0], new Vector3d())
            .cross(corners[2].sub(corners[0], new Vector3d()));
    double along = normal.dot(lamp.axis());
    double distance = corners[0].sub(lamp.position(), new Vector3d()).dot(normal) / along;
    if (!(distance > 0) || !Double.isFinite(distance)) {
      return false;
    }
    Vector3d hit = lamp.position().fma(distance, lamp.axis(), new Vector3d());
    ClosestPoint.onTriangle(corners[0], corners[1], corners[2], hit, spot);
    return departure(a, b, c) > 2 * tolerance;
  }

  /** Returns the error of interpolation at {@code spot} in the triangle. */
  private double departure(int a, int b, int c) {
    Vector3d u = corners[1].sub(corners[0], new Vector3d());
    Vector3d v = corners[2].sub(corners[0], new Vector3d());
    Vector3d w = spot.sub(corners[0], new Vector3d());
    Vector3d normal = u.cross(v, new Vector3d());
    double area = normal.lengthSquared();
    if (!(area > 0)) {
      return 0;
    }
    double ofB = w.cross(v, new Vector3d()).dot(normal) / area;
    double ofC = u.cross(w, new Vector3d()).dot(normal) / area;
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
    shares[0] = 1 - ofB - ofC;
    shares[1] = ofB;
    shares[2] = ofC;
    return departure(3);
  }

  private double departure(int a, int b, double share) {
    corner[0] = a;
    corner[1] = b;
    shares[0] = 1 - share;
    shares[1] = share;
    return departure(2);
  }

  /**
   * Returns the error of interpolation: the largest difference of a colour channel between the
   * light at a point, given by barycentric coordinates, and the interpolated light of the corners.
   */
  private double departure(int corners) {
    double[] p = vertices.placed();
    Arrays.fill(at, 0);
    Arrays.fill(straight, 0);
    for (int k = 0; k < corners; k++) {
      for (int i = 0; i < 6; i++) {
        at[i] += shares[k] * p[6 * corner[k] + i];
      }
      int known = light(corner[k]);
      for (int i = 0; i < straight.length; i++) {
        straight[i] += shares[k] * light[known + i];
      }
    }
    double length = Math.sqrt(at[3] * at[3] + at[4] * at[4] + at[5] * at[5]);
    double unit = length > 0 ? 1 / length : 0;
    Arrays.fill(sample, 0);
    light(at, 0, unit, sample, 0);
    double most = 0;
    for (int i = 0; i < sample.length; i++) {
      most = Math.max(most, Math.abs(sample[i] - straight[i]));
    }
    return most;
  }

  /** Returns the place of a vertex's light in {@code light}, computed when first asked for. */
  private int light(int vertex) {
    int at = sample.length * vertex;
    if (light.length < at + sample.length) {
      int before = light.length;
      light = Arrays.copyOf(light, Math.max(2 * before, sample.length * vertices.count()));
      Arrays.fill(light, before, light.length, NOT_KNOWN);
    }
    if (Double.isNaN(light[at])) {
      Arrays.fill(light, at, at + sample.length, 0);
      light(vertices.placed(), 6 * vertex, 1, light, at);
    }
    return at;
  }

  /** Adds the light on the front side, or on both sides. */
  private void light(double[] p, int i, double unit, double[] out, int at) {
    for (int side = 0; side < sides; side++) {
      double turn = side == 0 ? unit : -unit;
      field.add(
          p[i],
          p[i + 1],
          p[i + 2],
          turn * p[i + 3],
          turn * p[i + 4],
          turn * p[i + 5],
          out,
          at + 3 * side);
    }
  }
}
