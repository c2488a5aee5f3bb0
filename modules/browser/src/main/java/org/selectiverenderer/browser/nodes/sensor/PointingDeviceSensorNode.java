package org.selectiverenderer.browser.nodes.sensor;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A pointing device sensor for the geometry of its group (X3D 4.0, X3DPointingDeviceSensorNode,
 * 20.3.2). A dispatcher passes it every move, press and release that concerns it. If the button is
 * pressed over its geometry, the sensor is active until the release: it alone receives the pointer,
 * wherever that goes.
 */
public abstract class PointingDeviceSensorNode extends Node {
  private final int enabled;
  private final int isOver;
  private final int isActive;
  private final int description;
  private boolean pressedBefore;

  protected PointingDeviceSensorNode(
      NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    enabled = type.indexOf("enabled");
    isOver = type.indexOf("isOver");
    isActive = type.indexOf("isActive");
    description = type.indexOf("description");
  }

  public final boolean enabled() {
    return (Boolean) value(enabled);
  }

  /**
   * Returns whether the button was pressed over the sensor's geometry and is still down, so that
   * this sensor alone receives the pointer.
   */
  public final boolean active() {
    return (Boolean) value(isActive);
  }

  /** Returns whether the pointer is over the sensor's geometry. */
  public final boolean over() {
    return (Boolean) value(isOver);
  }

  /** Returns the author's description; may be empty. */
  public final String description() {
    return value(description) instanceof String text ? text : "";
  }

  /**
   * Returns whether this is a drag sensor, which uses motion of the pointer while the button is
   * held.
   */
  public abstract boolean drags();

  /**
   * Evaluates a state of the pointer.
   *
   * @param hit the point at which the pointer hits the sensor's geometry, in the sensor's local
   *     coordinates; empty if it does not
   * @param bearing the ray of the pointer; empty if it points at nothing
   * @param pressed whether the button is down now
   */
  public final void point(
      Optional<PointerHit> hit,
      Optional<PointerRay> bearing,
      boolean pressed,
      EventCascade cascade) {
    boolean goesDown = pressed && !pressedBefore;
    pressedBefore = pressed;
    if (!enabled()) {
      release(cascade); // Only if a reaction to its event disabled it.
      return;
    }
    boolean entered = hit.isPresent() && !over();
    sendState(isOver, hit.isPresent(), cascade);
    hit.ifPresent(at -> touched(at, entered, cascade));
    if (active()) {
      bearing.ifPresent(to -> dragged(to, cascade));
    }
    if (goesDown && hit.isPresent()) {
      bearing.ifPresent(to -> grabbed(hit.get(), to));
      sendState(isActive, true, cascade);
    } else if (!pressed && active()) {
      sendState(isActive, false, cascade);
      released(hit.isPresent(), cascade);
    }
  }

  /**
   * Is called while the pointer is over the sensor's geometry.
   *
   * @param entered whether the pointer was elsewhere before
   */
  protected void touched(PointerHit at, boolean entered, EventCascade cascade) {
    // Only some sensors report the point.
  }

  /**
   * Is called when the button goes down over the sensor's geometry, before {@code isActive} is
   * sent.
   */
  protected void grabbed(PointerHit at, PointerRay bearing) {
    // Only drag sensors use the starting point.
  }

  /** Is called with the pointer's ray, changed or not, while the sensor is active. */
  protected void dragged(PointerRay bearing, EventCascade cascade) {
    // Only drag sensors use it.
  }

  /**
   * Is called when the sensor becomes inactive.
   *
   * @param over whether the button was released over its geometry
   */
  protected abstract void released(boolean over, EventCascade cascade);

  private void sendState(int field, boolean now, EventCascade cascade) {
    if ((Boolean) value(field) != now) {
      emit(field, now, cascade);
    }
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    super.receive(field, value, cascade);
    if (field.index() == enabled && !enabled()) {
      release(cascade);
    }
  }

  /** Ends the activity of a sensor that is disabled. */
  private void release(EventCascade cascade) {
    if (active()) {
      sendState(isActive, false, cascade);
      released(false, cascade);
    }
    sendState(isOver, false, cascade);
  }
}
