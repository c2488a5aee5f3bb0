package org.selectiverenderer.browser.viewer;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

/**
 * The viewer's eye in world coordinates: right handed, Y up, lengths in the scene's unit. It looks
 * along the -Z axis of its own frame. Belongs to the thread that steps the world.
 */
public final class Viewer {
  private final Vector3d position = new Vector3d(0, 0, 10);
  private final Quaterniond orientation = new Quaterniond();
  private double fieldOfView = Math.PI / 4;
  private @Nullable OrthographicExtent extent;

  public Vector3dc position() {
    return position;
  }

  /** Returns the rotation from the viewer's frame to the world. */
  public Quaterniondc orientation() {
    return orientation;
  }

  /** Returns the smaller of the two viewing angles, in radians (X3D 4.0, 23.3.5). */
  public double fieldOfView() {
    return fieldOfView;
  }

  /** Returns the extent of an orthographic view; empty for a perspective view. */
  public Optional<OrthographicExtent> extent() {
    return Optional.ofNullable(extent);
  }

  /** Sets an orthographic view, or a perspective one if empty. */
  public void extent(Optional<OrthographicExtent> parallel) {
    extent = parallel.orElse(null);
  }

  /** Copies pose and projection of another viewer. */
  public void become(Viewer other) {
    moveTo(other.position);
    turnTo(other.orientation);
    fieldOfView = other.fieldOfView;
    extent = other.extent;
  }

  public void moveTo(Vector3dc eye) {
    position.set(eye);
  }

  public void turnTo(Quaterniondc rotation) {
    orientation.set(rotation).normalize();
  }

  public void fieldOfView(double radians) {
    fieldOfView = radians;
  }

  /** Returns the view matrix: from the world to the viewer's frame. */
  public Matrix4d view() {
    return new Matrix4d()
        .rotation(orientation.conjugate(new Quaterniond()))
        .translate(-position.x, -position.y, -position.z);
  }

  /**
   * Returns the orientation of yaw about Y, then pitch about X, then roll about Z (order YXZ);
   * radians; zero looks along -Z, positive yaw turns left, positive pitch looks up.
   */
  public static Quaterniond orientation(double yaw, double pitch, double roll) {
    return new Quaterniond().rotationYXZ(yaw, pitch, roll);
  }
}
