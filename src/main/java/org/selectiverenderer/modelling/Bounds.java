package org.selectiverenderer.modelling;

/** An axis-aligned box, metres. Of no points at all, it is inside out: min above max. */
public record Bounds(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {

  /** The box around points, x, y, z each. */
  public static Bounds of(float[] positions) {
    double[] b = {1e30, 1e30, 1e30, -1e30, -1e30, -1e30};
    for (int i = 0; i < positions.length; i++) {
      b[i % 3] = Math.min(b[i % 3], positions[i]);
      b[3 + i % 3] = Math.max(b[3 + i % 3], positions[i]);
    }
    return new Bounds(b[0], b[1], b[2], b[3], b[4], b[5]);
  }

  /** The smallest box around both. */
  public Bounds union(Bounds other) {
    return new Bounds(
        Math.min(minX, other.minX),
        Math.min(minY, other.minY),
        Math.min(minZ, other.minZ),
        Math.max(maxX, other.maxX),
        Math.max(maxY, other.maxY),
        Math.max(maxZ, other.maxZ));
  }

  public double width() {
    return maxX - minX;
  }

  public double height() {
    return maxY - minY;
  }

  public double depth() {
    return maxZ - minZ;
  }
}
