package org.selectiverenderer.runtime.render.window;

/** Something that the user did. Positions are in pixels from the upper left, y downwards. */
public sealed interface InputEvent {

  /**
   * A key went down, again and again while it is held, or up.
   *
   * @param character that it produced when it went down, with line feed for Enter and backspace for
   *     Backspace; empty for keys that produce none
   */
  record KeyInput(KeyboardKey key, boolean pressed, String character) implements InputEvent {
    /** A key that produces no character. */
    public KeyInput(KeyboardKey key, boolean pressed) {
      this(key, pressed, "");
    }
  }

  /**
   * A mouse button went down or up.
   *
   * @param button 1 left, 2 middle, 3 right
   */
  record ButtonInput(int button, boolean pressed, int x, int y) implements InputEvent {}

  /**
   * The mouse moved.
   *
   * @param dx since the last motion, in the desktop's units, so that a hand's movement means the
   *     same on a display of double density; 0 when the pointer has just entered
   * @param dy likewise, downwards
   */
  record MotionInput(int x, int y, double dx, double dy) implements InputEvent {}

  /**
   * The wheel turned.
   *
   * @param notches positive away from the user
   */
  record WheelInput(float notches) implements InputEvent {}

  /** The window lost the keyboard: keys that were down will not be heard going up. */
  record FocusLost() implements InputEvent {}
}
