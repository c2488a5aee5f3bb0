package org.selectiverenderer.runtime.nodes.sensor;

import java.util.Arrays;
import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Rotations;

/**
 * Sends {@code position_changed} and {@code orientation_changed} of a sensor: a pose of the world
 * in the sensor's local coordinates, when it differs from what was last sent. Where the place is
 * scaled unevenly or sheared, no rotation does that exactly; the one that keeps the looking
 * direction, and up as near as that allows, is sent.
 */
final class PoseReport {
  private final Node sensor;
  private final int positionChanged;
  private final int orientationChanged;
  private final Vector3d forward = new Vector3d();
  private final Vector3d up = new Vector3d();
  private final Matrix3d axes = new Matrix3d();
  private final Quaterniond turn = new Quaterniond();
  private final float[] orientation = new float[4];

  PoseReport(Node sensor) {
    this.sensor = sensor;
    positionChanged = sensor.type().indexOf("position_changed");
    orientationChanged = sensor.type().indexOf("orientation_changed");
  }

  /**
   * @param position in local coordinates
   * @param worldForward the pose's -Z axis in the world
   * @param worldUp its Y axis
   * @param always sends even what did not change
   */
  void send(
      LocalFrame frame,
      Vector3dc position,
      Vector3dc worldForward,
      Vector3dc worldUp,
      boolean always,
      Cascade cascade) {
    sendPoint(positionChanged, position, always, cascade);
    frame.direction(worldForward, forward);
    frame.direction(worldUp, up);
    Rotations.write(Rotations.looking(forward, up, axes, turn), orientation);
    float[] last = (float[]) sensor.value(orientationChanged);
    if (always || !Arrays.equals(last, orientation)) {
      sensor.emit(orientationChanged, orientation.clone(), cascade);
    }
  }

  /** Sends a point, when it differs from what the field last sent. */
  void sendPoint(int field, Vector3dc point, boolean always, Cascade cascade) {
    float x = (float) point.x();
    float y = (float) point.y();
    float z = (float) point.z();
    float[] last = (float[]) sensor.value(field);
    if (always || x != last[0] || y != last[1] || z != last[2]) {
      sensor.emit(field, new float[] {x, y, z}, cascade);
    }
  }
}
