package org.selectiverenderer.runtime.nodes.sound;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * How loud a sound is for each ear (X3D 4.0, 16.2.3 and 16.4.18): at its full intensity within the
 * inner of two ellipsoids, not heard outside the outer one, and between them from 0 dB to -20 dB,
 * even along the ray from the sound to the viewer. The sound is a focus of both.
 *
 * @param gain without direction
 * @param left share of the left ear
 * @param right share of the right ear
 */
record Hearing(double gain, double left, double right) {
  static final Hearing NOTHING = new Hearing(0, 1, 1);

  private static final double DECIBELS = -20;

  /**
   * A Sound in its own coordinates.
   *
   * @param direction of the front; of no length, it is that of the default, Z
   */
  record Ellipsoids(
      Vector3dc location,
      Vector3dc direction,
      double minFront,
      double minBack,
      double maxFront,
      double maxBack) {}

  /**
   * What is heard of a sound.
   *
   * @param place takes its coordinates to the world
   * @param eye of the viewer, in the world
   * @param orientation takes the viewer's frame, looking along -Z, to the world
   * @param spatialize whether it is heard from where it is, between the ellipsoids
   */
  static Hearing of(
      Ellipsoids sound,
      Matrix4dc place,
      Vector3dc eye,
      Quaterniondc orientation,
      boolean spatialize) {
    Matrix4d inverse = place.invert(new Matrix4d());
    if (!inverse.isFinite()) {
      return NOTHING; // A transformation above flattens it.
    }
    Vector3d away = inverse.transformPosition(eye, new Vector3d()).sub(sound.location);
    double distance = away.length();
    double cos = distance == 0 ? 1 : away.div(distance).dot(front(sound.direction));
    double inner = reach(sound.minFront, sound.minBack, cos);
    double outer = reach(sound.maxFront, sound.maxBack, cos);
    if (distance <= inner) {
      return new Hearing(1, 1, 1);
    }
    if (!(distance < outer)) {
      return NOTHING;
    }
    double gain = Math.pow(10, DECIBELS / 20 * (distance - inner) / (outer - inner));
    return spatialize ? panned(gain, pan(sound, place, eye, orientation)) : new Hearing(gain, 1, 1);
  }

  private static Vector3d front(Vector3dc direction) {
    return direction.length() == 0 ? new Vector3d(0, 0, 1) : direction.normalize(new Vector3d());
  }

  /** How far an ellipsoid reaches from its focus, at an angle to its front. */
  private static double reach(double front, double back, double cos) {
    double sum = front + back;
    return sum == 0 ? 0 : 2 * front * back / (sum - (front - back) * cos);
  }

  private static Hearing panned(double gain, double pan) {
    return new Hearing(gain, 1 - pan * pan, 1 - (1 - pan) * (1 - pan));
  }

  /** 0 at the left, 0.5 in front and behind, 1 at the right, even by the angle about the viewer. */
  private static double pan(
      Ellipsoids sound, Matrix4dc place, Vector3dc eye, Quaterniondc orientation) {
    Vector3d to = place.transformPosition(sound.location, new Vector3d()).sub(eye);
    orientation.conjugate(new Quaterniond()).transform(to);
    // The angle to the plane that parts left from right, seen from above.
    return 0.5 + Math.atan2(to.x, Math.abs(to.z)) / Math.PI;
  }
}
