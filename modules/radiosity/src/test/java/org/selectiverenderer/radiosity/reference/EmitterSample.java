package org.selectiverenderer.radiosity.reference;

/** A place of a lamp that was drawn at random; used again and again by one thread. */
final class EmitterSample {
  /** Unit vector from the point to the lamp. */
  final double[] towards = new double[3];

  /** How far it is; infinite for the sun. */
  double distance;

  /** Radiance r, g, b; of a lamp without extent the irradiance at right angles. */
  final double[] light = new double[3];

  /** Density of the direction per steradian; 0 for a lamp without extent. */
  double density;

  /** Aims from a point to a place; returns the square of the distance. */
  double aim(double[] from, double[] place) {
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
      towards[axis] = place[axis] - from[axis];
      square += towards[axis] * towards[axis];
    }
    distance = Math.sqrt(square);
    for (int axis = 0; axis < 3; axis++) {
      towards[axis] /= distance;
    }
    return square;
  }

  void shine(float[] rgb, double scale) {
    for (int i = 0; i < 3; i++) {
      light[i] = rgb[i] * scale;
    }
  }
}
