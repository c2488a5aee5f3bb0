package org.selectiverenderer.radiosity.texel;

/** Computes a tangent frame: two unit vectors at right angles to a normal and to each other. */
final class TangentFrame {
  private TangentFrame() {}

  /**
   * @param normals array with x, y, z of a unit normal
   * @param at index at which the normal begins
   */
  static void of(float[] normals, int at, double[] across, double[] along) {
    of(normals[at], normals[at + 1], normals[at + 2], across, along);
  }

  static void of(double[] normal, double[] across, double[] along) {
    of(normal[0], normal[1], normal[2], across, along);
  }

  private static void of(double x, double y, double z, double[] across, double[] along) {
    if (Math.abs(x) < Math.abs(y) && Math.abs(x) <= Math.abs(z)) {
      put(across, 0, -z, y, Math.sqrt(y * y + z * z));
    } else if (Math.abs(z) < Math.abs(y)) {
      put(across, -y, x, 0, Math.sqrt(x * x + y * y));
    } else {
      put(across, z, 0, -x, Math.sqrt(x * x + z * z));
    }
    along[0] = y * across[2] - z * across[1];
    along[1] = z * across[0] - x * across[2];
    along[2] = x * across[1] - y * across[0];
  }

  private static void put(double[] out, double x, double y, double z, double length) {
    out[0] = x / length;
    out[1] = y / length;
    out[2] = z / length;
  }
}
