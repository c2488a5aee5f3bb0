package org.selectiverenderer.runtime.nodes.script;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/** Takes what a Script receives. */
@FunctionalInterface
public interface ScriptCalls {
  /**
   * An event has arrived at a field that the Script's author declared; one of an inputOutput field
   * is kept and sent on already.
   *
   * @param value as {@link org.selectiverenderer.x3d.field.FieldType} represents it
   */
  void received(FieldDefinition field, @Nullable Object value, Cascade cascade);
}
