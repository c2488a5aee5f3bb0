package org.selectiverenderer.browser.nodes.sensor;

import java.util.Arrays;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * TouchSensor: detects the pointing device over geometry of its group, and clicks on it (X3D 4.0,
 * 20.4.4). Events of one call are sent in the order isOver, hitPoint, hitNormal and hitTexCoord as
 * far as they changed, isActive, touchTime.
 */
public class TouchSensorNode extends PointingDeviceSensorNode {
  private final int touchTime;
  private final int hitPoint;
  private final int hitNormal;
  private final int hitTexCoord;

  public TouchSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    touchTime = type.indexOf("touchTime");
    hitPoint = type.indexOf("hitPoint_changed");
    hitNormal = type.indexOf("hitNormal_changed");
    hitTexCoord = type.indexOf("hitTexCoord_changed");
  }

  @Override
  public boolean drags() {
    return false;
  }

  @Override
  protected void touched(PointerHit at, boolean entered, EventCascade cascade) {
    send(hitPoint, floats(at.point()), entered, cascade);
    send(hitNormal, floats(at.normal()), entered, cascade);
    send(hitTexCoord, new float[] {at.s(), at.t()}, entered, cascade);
  }

  @Override
  protected void released(boolean over, EventCascade cascade) {
    if (over) {
      emit(touchTime, cascade.time(), cascade);
    }
  }

  private void send(int field, float[] now, boolean always, EventCascade cascade) {
    if (always || !Arrays.equals((float[]) value(field), now)) {
      emit(field, now, cascade);
    }
  }

  /** Sends a field of doubles if it differs from the last value sent. */
  protected final void send(int field, double[] now, boolean always, EventCascade cascade) {
    if (always || !Arrays.equals((double[]) value(field), now)) {
      emit(field, now, cascade);
    }
  }

  private static float[] floats(Vector3dc v) {
    return new float[] {(float) v.x(), (float) v.y(), (float) v.z()};
  }
}
