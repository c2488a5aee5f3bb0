package org.selectiverenderer.browser.nodes.sound;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The gain of a Sound for each ear (X3D 4.0, 16.2.3 and 16.4.18): full intensity within the inner
 * of two ellipsoids, silence outside the outer one, and between them a fall from 0 dB to -20 dB,
 * linear along the ray from the sound to the viewer. The sound is at a focus of both ellipsoids.
 *
 * @param gain the gain without panning
 * @param left the share of the left ear
 * @param right the share of the right ear
 */
record SpatialAudioGain(double gain, double left, double right) {
  static final SpatialAudioGain NOTHING = new SpatialAudioGain(0, 1, 1);

  private static final double DECIBELS = -20;

  /**
   * The ellipsoids of a Sound in its local coordinates.
   *
   * @param direction the direction of the front; if it has no length, the default, Z
   */
  record Ellipsoids(
      Vector3dc location,
      Vector3dc direction,
      double minFront,
      double minBack,
      double maxFront,
      double maxBack) {}

  /**
   * Computes the gain of a sound.
   *
   * @param place the matrix from the sound's local coordinates to the world
   * @param eye the viewer's eye, in world coordinates
   * @param orientation the rotation from the viewer's frame, looking along -Z, to the world
   * @param spatialize whether the sound is panned by its direction, between the ellipsoids
   */
  static SpatialAudioGain of(
      Ellipsoids sound,
      Matrix4dc place,
      Vector3dc eye,
      Quaterniondc orientation,
      boolean spatialize) {
    Matrix4d inverse = place.invert(new Matrix4d());
    if (!inverse.isFinite()) {
      return NOTHING; // A scale of 0 above silences it.
    }
    Vector3d away = inverse.transformPosition(eye, new Vector3d()).sub(sound.location);
    double distance = away.length();
    double cos = distance == 0 ? 1 : away.div(distance).dot(front(sound.direction));
    double inner = reach(sound.minFront, sound.minBack, cos);
    double outer = reach(sound.maxFront, sound.maxBack, cos);
    if (distance <= inner) {
      return new SpatialAudioGain(1, 1, 1);
    }
    if (!(distance < outer)) {
      return NOTHING;
    }
    double gain = Math.pow(10, DECIBELS / 20 * (distance - inner) / (outer - inner));
    return spatialize
        ? panned(gain, pan(sound, place, eye, orientation))
        : new SpatialAudioGain(gain, 1, 1);
  }

  private static Vector3d front(Vector3dc direction) {
    return direction.length() == 0 ? new Vector3d(0, 0, 1) : direction.normalize(new Vector3d());
  }

  /** Returns the distance from the focus to the ellipsoid at an angle to the front. */
  private static double reach(double front, double back, double cos) {
    double sum = front + back;
    return sum == 0 ? 0 : 2 * front * back / (sum - (front - back) * cos);
  }

  private static SpatialAudioGain panned(double gain, double pan) {
    return new SpatialAudioGain(gain, 1 - pan * pan, 1 - (1 - pan) * (1 - pan));
  }

  /**
   * Returns the pan: 0 at the left, 0.5 in front and behind, 1 at the right, linear in the angle
   * about the viewer.
   */
  private static double pan(
      Ellipsoids sound, Matrix4dc place, Vector3dc eye, Quaterniondc orientation) {
    Vector3d to = place.transformPosition(sound.location, new Vector3d()).sub(eye);
    orientation.conjugate(new Quaterniond()).transform(to);
    // The angle to the median plane, seen from above.
    return 0.5 + Math.atan2(to.x, Math.abs(to.z)) / Math.PI;
  }
}
