package org.selectiverenderer.browser.scene;

import org.jspecify.annotations.Nullable;

/**
 * Is called with the events that a field sends, after the cascade has come to rest. It may set
 * fields, which starts a further cascade with the same time stamp. An exception is reported; the
 * other listeners are still called.
 */
@FunctionalInterface
public interface FieldListener {
  /**
   * @param value as {@link org.selectiverenderer.x3d.field.FieldType} represents it
   * @param time the event's time stamp in seconds
   */
  void fieldChanged(Node node, int field, @Nullable Object value, double time);
}
