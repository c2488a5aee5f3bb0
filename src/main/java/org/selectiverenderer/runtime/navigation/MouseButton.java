package org.selectiverenderer.runtime.navigation;

/** A button of the mouse. */
public enum MouseButton {
  LEFT,
  MIDDLE,
  RIGHT
}
