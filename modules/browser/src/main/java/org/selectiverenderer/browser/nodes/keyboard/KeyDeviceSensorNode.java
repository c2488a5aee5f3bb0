package org.selectiverenderer.browser.nodes.keyboard;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A key device sensor (X3D 4.0, X3DKeyDeviceSensorNode, 21.3.1). Enabling it makes it active and
 * disables the one active before: only one sensor of a world is active at a time.
 */
public abstract class KeyDeviceSensorNode extends Node {
  private final int enabled;
  private final int isActive;
  private @Nullable KeyDevice device;

  KeyDeviceSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    enabled = type.indexOf("enabled");
    isActive = type.indexOf("isActive");
  }

  final boolean enabled() {
    return (Boolean) value(enabled);
  }

  /** Sets the keyboard of the scene that the sensor entered; null when it left. */
  final void join(@Nullable KeyDevice ofScene) {
    device = ofScene;
  }

  final void disable(EventCascade cascade) {
    cascade.send(this, enabled, false);
  }

  final void activate(boolean active, EventCascade cascade) {
    if ((Boolean) value(isActive) != active) {
      begin();
      emit(isActive, active, cascade);
    }
  }

  /** Starts anew, without the keys typed before. */
  abstract void begin();

  /** Returns whether the sensor uses a key, so that the program must not react to it. */
  abstract boolean wants(KeyboardEvent.Key key);

  /** Is called when a key goes down or up while the sensor is active. */
  abstract void type(KeyboardEvent stroke, EventCascade cascade);

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    super.receive(field, value, cascade);
    KeyDevice keys = device;
    if (field.index() == enabled && keys != null) {
      keys.enabled(this, cascade);
    }
  }
}
