package org.selectiverenderer.geometry.mesh;

/** Computes texture coordinates for surfaces that specify none (X3D 4.0, 13.3.6). */
final class DefaultTexCoords {
  private DefaultTexCoords() {}

  /**
   * Returns coordinates in which S runs from 0 to 1 along the longest side of the bounding box, and
   * T along the second longest from 0 to the ratio of the two. Of equal sides X precedes Y and Z.
   *
   * @return s, t per vertex
   */
  static float[] of(float[] positions, float[] bounds) {
    double[] size = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      size[axis] = (double) bounds[axis + 3] - bounds[axis];
    }
    int s = longest(size, -1);
    int t = longest(size, s);
    double scale = size[s] > 0 ? 1 / size[s] : 0;
    float[] texCoords = new float[positions.length / 3 * 2];
    for (int i = 0, j = 0; i < positions.length; i += 3, j += 2) {
      texCoords[j] = (float) (((double) positions[i + s] - bounds[s]) * scale);
      texCoords[j + 1] = (float) (((double) positions[i + t] - bounds[t]) * scale);
    }
    return texCoords;
  }

  /** Returns the axis of the greatest size other than {@code except}; the first of equals. */
  private static int longest(double[] size, int except) {
    int longest = except == 0 ? 1 : 0;
    for (int axis = longest + 1; axis < 3; axis++) {
      if (axis != except && size[axis] > size[longest]) {
        longest = axis;
      }
    }
    return longest;
  }
}
