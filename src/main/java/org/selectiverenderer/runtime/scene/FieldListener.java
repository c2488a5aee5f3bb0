package org.selectiverenderer.runtime.scene;

import org.jspecify.annotations.Nullable;

/**
 * Hears the events that a field sends, after the cascade that carried them came to rest. It may set
 * fields: that begins a further cascade at the same time. One that throws is reported; the others
 * are called nevertheless.
 */
@FunctionalInterface
public interface FieldListener {
  /**
   * @param value as {@link org.selectiverenderer.x3d.field.FieldType} represents it
   * @param time the event's time stamp in seconds
   */
  void fieldChanged(Node node, int field, @Nullable Object value, double time);
}
