package org.selectiverenderer.runtime.render.window;

/** Something that the user did. Positions are in pixels from the upper left, y downwards. */
public sealed interface InputEvent {

  /** Held-down keys that change what others mean. */
  record Modifiers(boolean shift, boolean control, boolean alt) {}

  /**
   * A key went down, again while it is held (repeat), or up.
   *
   * @param repeat whether the keyboard sent it because the key is held
   */
  record KeyInput(Key key, boolean pressed, boolean repeat, Modifiers modifiers)
      implements InputEvent {}

  /**
   * A mouse button went down or up.
   *
   * @param button 1 left, 2 middle, 3 right
   */
  record ButtonInput(int button, boolean pressed, int x, int y, Modifiers modifiers)
      implements InputEvent {}

  /**
   * The mouse moved.
   *
   * @param dx since the last motion; 0 when the pointer has just entered
   * @param dy likewise, downwards
   * @param button the button that is held, 0 for none
   */
  record MotionInput(int x, int y, int dx, int dy, int button, Modifiers modifiers)
      implements InputEvent {}

  /**
   * The wheel turned.
   *
   * @param notches positive away from the user
   */
  record WheelInput(float notches, int x, int y, Modifiers modifiers) implements InputEvent {}

  /** The window lost the keyboard: keys that were down will not be heard going up. */
  record FocusLost() implements InputEvent {}
}
