package org.selectiverenderer.apparatus;

/** A button of the mouse. */
public enum MouseButton {
  LEFT,
  MIDDLE,
  RIGHT
}
