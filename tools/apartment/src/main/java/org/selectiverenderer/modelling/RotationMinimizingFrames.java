package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.DegreeMath;

/**
 * Rotation minimizing frames along a spine, one per point, by double reflection (Wang et al.,
 * Computation of Rotation Minimizing Frames, 2008).
 */
final class RotationMinimizingFrames {
  /** Mitre limit: largest factor by which the section is stretched at a corner. */
  private static final double MITRE = 3;

  private final List<Vector3d> points;
  private final boolean closed;
  private final List<Vector3d> tangents = new ArrayList<>();
  private final List<Vector3d> ups = new ArrayList<>();

  RotationMinimizingFrames(Spine spine) {
    this.points = spine.points();
    this.closed = spine.closed();
    for (int i = 0; i < points.size(); i++) {
      tangents.add(into(i).add(outOf(i)).normalize());
    }
    Vector3d first = tangents.get(0);
    Vector3d up = Math.abs(first.y) > 0.9 ? new Vector3d(0, 0, -1) : new Vector3d(0, 1, 0);
    ups.add(across(up, first));
    for (int i = 1; i < points.size(); i++) {
      ups.add(reflected(i - 1, i));
    }
    if (closed) {
      untwist();
    }
  }

  /** Returns the position of the section's point (x, y) at point {@code i} of the spine. */
  Vector3d place(int i, double x, double y) {
    Vector3d up = ups.get(i);
    Vector3d right = tangents.get(i).cross(up, new Vector3d());
    Vector3d offset = new Vector3d(right).mul(x).fma(y, up);
    Vector3d bend = outOf(i).sub(into(i));
    double cosine = outOf(i).dot(tangents.get(i));
    if (bend.lengthSquared() > 1e-12 && cosine < 1) {
      bend.normalize();
      offset.fma(offset.dot(bend) * (Math.min(MITRE, 1 / cosine) - 1), bend);
    }
    return offset.add(points.get(i));
  }

  private Vector3d into(int i) {
    return i == 0 && !closed ? outOf(0) : direction(Math.floorMod(i - 1, points.size()), i);
  }

  private Vector3d outOf(int i) {
    return i == points.size() - 1 && !closed
        ? direction(i - 1, i)
        : direction(i, (i + 1) % points.size());
  }

  private Vector3d direction(int from, int to) {
    return new Vector3d(points.get(to)).sub(points.get(from)).normalize();
  }

  private static Vector3d across(Vector3d v, Vector3d tangent) {
    return v.fma(-v.dot(tangent), tangent).normalize();
  }

  private Vector3d reflected(int from, int to) {
    Vector3d v = new Vector3d(points.get(to)).sub(points.get(from));
    double c = v.lengthSquared();
    Vector3d up = new Vector3d(ups.get(from));
    up.fma(-2 / c * v.dot(up), v);
    Vector3d tangent = new Vector3d(tangents.get(from));
    tangent.fma(-2 / c * v.dot(tangent), v);
    Vector3d w = new Vector3d(tangents.get(to)).sub(tangent);
    double d = w.lengthSquared();
    if (d > 1e-18) {
      up.fma(-2 / d * w.dot(up), w);
    }
    return across(up, tangents.get(to));
  }

  /**
   * Distributes the closing angle, by which the frame of a closed spine returns rotated, over all
   * points.
   */
  private void untwist() {
    int n = points.size();
    Vector3d back = reflected(n - 1, 0);
    Vector3d first = ups.get(0);
    double sine = first.cross(back, new Vector3d()).dot(tangents.get(0));
    double twist = DegreeMath.atan2(sine, first.dot(back));
    for (int i = 1; i < n; i++) {
      double angle = -twist * i / n;
      Vector3d up = ups.get(i);
      Vector3d side = tangents.get(i).cross(up, new Vector3d());
      up.mul(DegreeMath.cos(angle)).fma(DegreeMath.sin(angle), side);
    }
  }
}
