package org.selectiverenderer.browser.viewer;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The pose of a viewer in the world: position, orientation and field of view.
 *
 * @param orientation the rotation from the viewer's frame, looking along -Z, to the world
 * @param fieldOfView the smaller viewing angle in radians
 */
public record Pose(Vector3dc position, Quaterniondc orientation, double fieldOfView) {
  public Pose {
    position = new Vector3d(position);
    orientation = new Quaterniond(orientation).normalize();
  }

  public static Pose of(Viewer viewer) {
    return new Pose(viewer.position(), viewer.orientation(), viewer.fieldOfView());
  }

  /** Moves a viewer to this pose, with a perspective view. */
  public void applyTo(Viewer viewer) {
    viewer.moveTo(position);
    viewer.turnTo(orientation);
    viewer.fieldOfView(fieldOfView);
    viewer.extent(Optional.empty());
  }

  /** Returns the matrix from the viewer's frame to the world. */
  public Matrix4d matrix() {
    return new Matrix4d().translationRotate(position, orientation);
  }

  /**
   * Returns a pose with the same field of view elsewhere.
   *
   * @param matrix the matrix from the viewer's frame to the world; a rigid transformation
   */
  public Pose at(Matrix4dc matrix) {
    return new Pose(
        matrix.getTranslation(new Vector3d()),
        matrix.getNormalizedRotation(new Quaterniond()),
        fieldOfView);
  }

  /**
   * Interpolates between this pose (0) and another (1): linearly in position, the short way in
   * rotation.
   */
  public Pose towards(Pose other, double share) {
    return new Pose(
        position.lerp(other.position, share, new Vector3d()),
        orientation.slerp(other.orientation, share, new Quaterniond()),
        fieldOfView + share * (other.fieldOfView - fieldOfView));
  }
}
