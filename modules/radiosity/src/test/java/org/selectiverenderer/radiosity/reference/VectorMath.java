package org.selectiverenderer.radiosity.reference;

/** Three numbers as a vector. */
final class VectorMath {
  private VectorMath() {}

  static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static double distance(double[] a, double[] b) {
    double x = a[0] - b[0];
    double y = a[1] - b[1];
    double z = a[2] - b[2];
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** A direction about a unit normal, as dense as its cosine (a disc's points lifted up). */
  static void cosine(double[] normal, double s, double t, double[] out) {
    double radius = Math.sqrt(s);
    double angle = 2 * Math.PI * t;
    double x = radius * StrictMath.cos(angle);
    double y = radius * StrictMath.sin(angle);
    double z = Math.sqrt(Math.max(0, 1 - s));
    // Any two vectors at right angles to the normal and each other.
    double[] n = normal;
    double ax = Math.abs(n[0]) < 0.6 ? 1 : 0;
    double ay = 1 - ax;
    double along = ax * n[0] + ay * n[1];
    double ux = ax - along * n[0];
    double uy = ay - along * n[1];
    double uz = -along * n[2];
    double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
    ux /= length;
    uy /= length;
    uz /= length;
    double vx = n[1] * uz - n[2] * uy;
    double vy = n[2] * ux - n[0] * uz;
    double vz = n[0] * uy - n[1] * ux;
    out[0] = x * ux + y * vx + z * n[0];
    out[1] = x * uy + y * vy + z * n[1];
    out[2] = x * uz + y * vz + z * n[2];
  }
}
