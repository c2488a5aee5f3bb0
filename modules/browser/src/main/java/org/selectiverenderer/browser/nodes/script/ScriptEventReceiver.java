package org.selectiverenderer.browser.nodes.script;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/** Receives the events that arrive at a Script. */
@FunctionalInterface
public interface ScriptEventReceiver {
  /**
   * Is called when an event arrives at a field that the Script's author declared; for an
   * inputOutput field after the value was stored and forwarded.
   *
   * @param value as {@link org.selectiverenderer.x3d.field.FieldType} represents it
   */
  void received(FieldDefinition field, @Nullable Object value, EventCascade cascade);
}
