package org.selectiverenderer.geometry.bvh;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Computes the closest point on a segment or triangle to a point (Ericson 2005, 5.1). */
public final class ClosestPoint {
  private ClosestPoint() {}

  /** Computes the point of the segment ab closest to p; a if the segment is degenerate. */
  public static void onSegment(Vector3dc a, Vector3dc b, Vector3dc p, Vector3d out) {
    double abx = b.x() - a.x();
    double aby = b.y() - a.y();
    double abz = b.z() - a.z();
    double length = abx * abx + aby * aby + abz * abz;
    double along = (p.x() - a.x()) * abx + (p.y() - a.y()) * aby + (p.z() - a.z()) * abz;
    double t = length > 0 ? Math.max(0, Math.min(1, along / length)) : 0;
    out.set(a.x() + t * abx, a.y() + t * aby, a.z() + t * abz);
  }

  /** Computes the point of the triangle abc closest to p. */
  public static void onTriangle(Vector3dc a, Vector3dc b, Vector3dc c, Vector3dc p, Vector3d out) {
    Vector3d ab = b.sub(a, new Vector3d());
    Vector3d ac = c.sub(a, new Vector3d());
    Vector3d normal = ab.cross(ac, new Vector3d());
    double area = normal.lengthSquared();
    if (area > 0) {
      Vector3d ap = p.sub(a, new Vector3d());
      double v = ap.cross(ac, new Vector3d()).dot(normal) / area;
      double w = ab.cross(ap, new Vector3d()).dot(normal) / area;
      if (v >= 0 && w >= 0 && v + w <= 1) {
        out.set(a).fma(v, ab).fma(w, ac);
        return;
      }
    }
    // p projects outside the triangle, or the triangle is degenerate: take the closest edge
    Vector3d candidate = new Vector3d();
    onSegment(a, b, p, out);
    onSegment(b, c, p, candidate);
    nearer(out, candidate, p);
    onSegment(c, a, p, candidate);
    nearer(out, candidate, p);
  }

  private static void nearer(Vector3d best, Vector3dc candidate, Vector3dc p) {
    if (candidate.distanceSquared(p) < best.distanceSquared(p)) {
      best.set(candidate);
    }
  }
}
