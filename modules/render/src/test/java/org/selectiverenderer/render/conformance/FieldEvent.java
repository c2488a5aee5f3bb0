package org.selectiverenderer.render.conformance;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldType;

/** An event: the value that a field sent at a time. */
record FieldEvent(double time, String nodeAndField, FieldType type, @Nullable Object value) {
  private static final double TIME_TOLERANCE = 1e-6;

  /** Returns whether the event matches {@code TIME NODE.field VALUE}. */
  boolean is(String expected) {
    return Math.abs(time - Double.parseDouble(ConformanceScene.word(expected, 0))) < TIME_TOLERANCE
        && isValue(ConformanceScene.rest(expected, 1));
  }

  /** Returns whether the event matches {@code NODE.field VALUE}, at any time. */
  boolean isValue(String expected) {
    return ConformanceScene.word(expected, 0).equals(nodeAndField)
        && FieldValueFormat.agree(type, value, ConformanceScene.rest(expected, 1));
  }

  @Override
  public String toString() {
    return time + " " + nodeAndField + " " + FieldValueFormat.text(value);
  }
}
