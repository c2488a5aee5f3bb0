package org.selectiverenderer.runtime.walk;

/** A button of the mouse. */
public enum MouseButton {
  LEFT,
  MIDDLE,
  RIGHT
}
