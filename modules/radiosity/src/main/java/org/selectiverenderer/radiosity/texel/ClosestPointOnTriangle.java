package org.selectiverenderer.radiosity.texel;

/**
 * Finds the closest point on a triangle to a point (Ericson 2005, 5.1.5). Allocates nothing; one
 * per thread.
 */
final class ClosestPointOnTriangle {
  private final float[] corners;
  private double u;
  private double v;

  /**
   * @param corners x, y, z of the corners, nine numbers per triangle
   */
  ClosestPointOnTriangle(float[] corners) {
    this.corners = corners;
  }

  /** Returns the barycentric weight of the second corner at the point found last. */
  double u() {
    return u;
  }

  /** Returns the barycentric weight of the third corner at the point found last. */
  double v() {
    return v;
  }

  /** Finds the closest point; returns the squared distance. */
  double nearest(int triangle, double[] p) {
    int at = 9 * triangle;
    double bb = 0;
    double bc = 0;
    double cc = 0;
    double pb = 0;
    double pc = 0;
    for (int axis = 0; axis < 3; axis++) {
      double a = corners[at + axis];
      double b = corners[at + 3 + axis] - a;
      double c = corners[at + 6 + axis] - a;
      double q = p[axis] - a;
      bb += b * b;
      bc += b * c;
      cc += c * c;
      pb += q * b;
      pc += q * c;
    }
    weigh(bb, bc, cc, pb, pc);
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      double a = corners[at + axis];
      double d = a + u * (corners[at + 3 + axis] - a) + v * (corners[at + 6 + axis] - a) - p[axis];
      sum += d * d;
    }
    return sum;
  }

  private void weigh(double bb, double bc, double cc, double pb, double pc) {
    double scale = bb * cc - bc * bc;
    if (scale > 0) {
      u = (cc * pb - bc * pc) / scale;
      v = (bb * pc - bc * pb) / scale;
      if (u >= 0 && v >= 0 && u + v <= 1) {
        return;
      }
    }
    // The projection lies outside of the triangle, or the triangle is degenerate: take the closest
    // point on its three edges.
    double best = Double.POSITIVE_INFINITY;
    double bestU = 0;
    double bestV = 0;
    for (int edge = 0; edge < 3; edge++) {
      double eu;
      double ev;
      if (edge == 0) {
        eu = share(pb, bb);
        ev = 0;
      } else if (edge == 1) {
        eu = 0;
        ev = share(pc, cc);
      } else {
        ev = share(pc - pb + bb - bc, bb - 2 * bc + cc);
        eu = 1 - ev;
      }
      // The squared distance without its constant term.
      double away = eu * (eu * bb - 2 * pb) + ev * (ev * cc - 2 * pc) + 2 * eu * ev * bc;
      if (away < best) {
        best = away;
        bestU = eu;
        bestV = ev;
      }
    }
    u = bestU;
    v = bestV;
  }

  private static double share(double along, double length) {
    return length > 0 ? Math.max(0, Math.min(1, along / length)) : 0;
  }
}
