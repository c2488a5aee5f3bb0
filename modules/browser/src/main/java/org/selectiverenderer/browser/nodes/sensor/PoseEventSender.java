package org.selectiverenderer.browser.nodes.sensor;

import java.util.Arrays;
import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Rotations;

/**
 * Sends {@code position_changed} and {@code orientation_changed} of a sensor: a world pose in the
 * sensor's local coordinates, if it differs from the last one sent. Under a non-uniform scale or a
 * shear no rotation is exact; the rotation sent keeps the viewing direction exactly and the up
 * direction as nearly as possible.
 */
final class PoseEventSender {
  private final Node sensor;
  private final int positionChanged;
  private final int orientationChanged;
  private final Vector3d forward = new Vector3d();
  private final Vector3d up = new Vector3d();
  private final Matrix3d axes = new Matrix3d();
  private final Quaterniond turn = new Quaterniond();
  private final float[] orientation = new float[4];

  PoseEventSender(Node sensor) {
    this.sensor = sensor;
    positionChanged = sensor.type().indexOf("position_changed");
    orientationChanged = sensor.type().indexOf("orientation_changed");
  }

  /**
   * @param position the position in local coordinates
   * @param worldForward the pose's -Z axis in the world
   * @param worldUp the pose's Y axis in the world
   * @param always whether to send values that have not changed
   */
  void send(
      WorldToLocalTransform frame,
      Vector3dc position,
      Vector3dc worldForward,
      Vector3dc worldUp,
      boolean always,
      EventCascade cascade) {
    sendPoint(positionChanged, position, always, cascade);
    frame.direction(worldForward, forward);
    frame.direction(worldUp, up);
    Rotations.write(Rotations.looking(forward, up, axes, turn), orientation);
    float[] last = (float[]) sensor.value(orientationChanged);
    if (always || !Arrays.equals(last, orientation)) {
      sensor.emit(orientationChanged, orientation.clone(), cascade);
    }
  }

  /** Sends a point if it differs from the last one sent by the field. */
  void sendPoint(int field, Vector3dc point, boolean always, EventCascade cascade) {
    float x = (float) point.x();
    float y = (float) point.y();
    float z = (float) point.z();
    float[] last = (float[]) sensor.value(field);
    if (always || x != last[0] || y != last[1] || z != last[2]) {
      sensor.emit(field, new float[] {x, y, z}, cascade);
    }
  }
}
