package org.selectiverenderer.runtime.nodes.sensor;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A sensor of the pointing device over geometry of its group (X3D 4.0, X3DPointingDeviceSensorNode,
 * 20.3.2). Who dispatches the pointer tells it of every move, press and release that concern it.
 * While the button that went down over it is held it is active: it alone hears of the pointer,
 * wherever that goes.
 */
public abstract class PointingSensorNode extends Node {
  private final int enabled;
  private final int isOver;
  private final int isActive;
  private final int description;
  private boolean pressedBefore;

  protected PointingSensorNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    enabled = type.indexOf("enabled");
    isOver = type.indexOf("isOver");
    isActive = type.indexOf("isActive");
    description = type.indexOf("description");
  }

  public final boolean enabled() {
    return (Boolean) value(enabled);
  }

  /** Whether the button was pressed over it and is still down: it alone hears of the pointer. */
  public final boolean active() {
    return (Boolean) value(isActive);
  }

  /** Whether the pointer is over its geometry. */
  public final boolean over() {
    return (Boolean) value(isOver);
  }

  /** What the author says that it is for; may be empty. */
  public final String description() {
    return value(description) instanceof String text ? text : "";
  }

  /** Whether moving the pointer while the button is held means something to it. */
  public abstract boolean drags();

  /**
   * The pointer moved, or its button went down or up.
   *
   * @param hit where it meets the sensor's geometry, in the sensor's local coordinates; empty when
   *     it is elsewhere
   * @param bearing where it points; empty when it points nowhere
   * @param pressed whether the button is down now
   */
  public final void point(
      Optional<PointerHit> hit, Optional<Bearing> bearing, boolean pressed, Cascade cascade) {
    boolean goesDown = pressed && !pressedBefore;
    pressedBefore = pressed;
    if (!enabled()) {
      release(cascade); // Only if an answer to its own event disabled it.
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
   * The pointer is over its geometry.
   *
   * @param entered whether it was elsewhere before
   */
  protected void touched(PointerHit at, boolean entered, Cascade cascade) {
    // Only some say where.
  }

  /** The button goes down over its geometry; {@code isActive} is sent afterwards. */
  protected void grabbed(PointerHit at, Bearing bearing) {
    // Only a drag begins somewhere.
  }

  /** While it is active: the pointer's bearing, changed or not. */
  protected void dragged(Bearing bearing, Cascade cascade) {
    // Only drag sensors do.
  }

  /**
   * It is no longer active.
   *
   * @param over whether the button was released over its geometry
   */
  protected abstract void released(boolean over, Cascade cascade);

  private void sendState(int field, boolean now, Cascade cascade) {
    if ((Boolean) value(field) != now) {
      emit(field, now, cascade);
    }
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    super.receive(field, value, cascade);
    if (field.index() == enabled && !enabled()) {
      release(cascade);
    }
  }

  /** A sensor that is disabled lets go of the pointer. */
  private void release(Cascade cascade) {
    if (active()) {
      sendState(isActive, false, cascade);
      released(false, cascade);
    }
    sendState(isOver, false, cascade);
  }
}
