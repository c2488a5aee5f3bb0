package org.selectiverenderer.runtime.nodes.sensor;

import java.util.Arrays;
import java.util.Optional;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Notices the pointing device over geometry of its group, and clicks on it (X3D 4.0, 20.4.4). Who
 * dispatches the pointer tells it of every move, press and release that concern it. Events of one
 * call come in the order: isOver, hitPoint, hitNormal and hitTexCoord as far as they changed,
 * isActive, touchTime.
 */
public class TouchSensorNode extends Node {
  private final int enabled;
  private final int isOver;
  private final int isActive;
  private final int touchTime;
  private final int hitPoint;
  private final int hitNormal;
  private final int hitTexCoord;
  private boolean pressedBefore;

  public TouchSensorNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    enabled = type.indexOf("enabled");
    isOver = type.indexOf("isOver");
    isActive = type.indexOf("isActive");
    touchTime = type.indexOf("touchTime");
    hitPoint = type.indexOf("hitPoint_changed");
    hitNormal = type.indexOf("hitNormal_changed");
    hitTexCoord = type.indexOf("hitTexCoord_changed");
  }

  public boolean enabled() {
    return (Boolean) value(enabled);
  }

  /** Whether the button was pressed over it and is still down: it alone hears of the pointer. */
  public boolean active() {
    return (Boolean) value(isActive);
  }

  /** Whether the pointer is over its geometry. */
  public boolean over() {
    return (Boolean) value(isOver);
  }

  /**
   * The pointer moved, or its button went down or up.
   *
   * @param hit where it meets the sensor's geometry, in the sensor's local coordinates; empty when
   *     it is elsewhere
   * @param pressed whether the button is down now
   */
  public void point(Optional<PointerHit> hit, boolean pressed, Cascade cascade) {
    boolean goesDown = pressed && !pressedBefore;
    pressedBefore = pressed;
    if (!enabled()) {
      release(cascade); // Only if an answer to its own event disabled it.
      return;
    }
    boolean entered = hit.isPresent() && !over();
    sendState(isOver, hit.isPresent(), cascade);
    hit.ifPresent(at -> sendHit(at, entered, cascade));
    if (goesDown && hit.isPresent()) {
      sendState(isActive, true, cascade);
    } else if (!pressed && active()) {
      sendState(isActive, false, cascade);
      if (hit.isPresent()) {
        emit(touchTime, cascade.time(), cascade);
      }
    }
  }

  private void sendState(int field, boolean now, Cascade cascade) {
    if ((Boolean) value(field) != now) {
      emit(field, now, cascade);
    }
  }

  /** Sends where the pointer meets the geometry. */
  protected void sendHit(PointerHit at, boolean always, Cascade cascade) {
    send(hitPoint, floats(at.point()), always, cascade);
    send(hitNormal, floats(at.normal()), always, cascade);
    send(hitTexCoord, new float[] {at.s(), at.t()}, always, cascade);
  }

  private void send(int field, float[] now, boolean always, Cascade cascade) {
    if (always || !Arrays.equals((float[]) value(field), now)) {
      emit(field, now, cascade);
    }
  }

  /** Sends a field of doubles, when it differs from what was last sent. */
  protected final void send(int field, double[] now, boolean always, Cascade cascade) {
    if (always || !Arrays.equals((double[]) value(field), now)) {
      emit(field, now, cascade);
    }
  }

  private static float[] floats(Vector3dc v) {
    return new float[] {(float) v.x(), (float) v.y(), (float) v.z()};
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    super.receive(field, value, cascade);
    if (field.index() == enabled && !enabled()) {
      release(cascade);
    }
  }

  private void release(Cascade cascade) {
    sendState(isActive, false, cascade);
    sendState(isOver, false, cascade);
  }
}
