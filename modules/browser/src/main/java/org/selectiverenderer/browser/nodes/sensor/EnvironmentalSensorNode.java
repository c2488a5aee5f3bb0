package org.selectiverenderer.browser.nodes.sensor;

import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * An environmental sensor, which senses events in a box (X3D 4.0, X3DEnvironmentalSensorNode,
 * 22.3.1). Entering sends {@code isActive TRUE}, then {@code enterTime}; leaving sends {@code
 * isActive FALSE}, then {@code exitTime}; both with the time stamp of the frame. An active sensor
 * that is disabled leaves at once, with the time stamp of the event that disabled it.
 */
abstract class EnvironmentalSensorNode extends Node implements FrameDrivenNode {
  private final int enabled;
  private final int center;
  private final int size;
  private final int isActive;
  private final int enterTime;
  private final int exitTime;

  EnvironmentalSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    enabled = type.indexOf("enabled");
    center = type.indexOf("center");
    size = type.indexOf("size");
    isActive = type.indexOf("isActive");
    enterTime = type.indexOf("enterTime");
    exitTime = type.indexOf("exitTime");
  }

  final boolean enabled() {
    return (Boolean) value(enabled);
  }

  /** Returns whether the sensor is active. */
  public final boolean active() {
    return (Boolean) value(isActive);
  }

  /** Returns whether a field determines the position or size of the box. */
  public boolean hasBoxOf(int field) {
    return field == center || field == size;
  }

  /** Returns the centre of the box in local coordinates. */
  protected float[] center() {
    return (float[]) value(center);
  }

  final float[] size() {
    return (float[]) value(size);
  }

  /** Returns whether the box has a volume: all of its sizes are positive. */
  final boolean hasVolume() {
    float[] s = size();
    return s[0] > 0 && s[1] > 0 && s[2] > 0;
  }

  /**
   * Returns whether a point in local coordinates is in the box or on its boundary; false for NaN.
   */
  final boolean contains(Vector3dc local) {
    float[] c = center();
    float[] s = size();
    return Math.abs(local.x() - c[0]) <= s[0] / 2.0
        && Math.abs(local.y() - c[1]) <= s[1] / 2.0
        && Math.abs(local.z() - c[2]) <= s[2] / 2.0;
  }

  /**
   * Sends the events of a change of state. If a reaction to isActive disables the sensor, that
   * takes effect in the next frame, since a field sends one event per cascade.
   */
  final void sense(boolean inside, EventCascade cascade) {
    if (inside == active()) {
      return;
    }
    emit(isActive, inside, cascade);
    if (inside == active()) {
      emit(inside ? enterTime : exitTime, cascade.time(), cascade);
    }
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    super.receive(field, value, cascade);
    if (field.index() == enabled && !enabled()) {
      sense(false, cascade);
    }
  }
}
