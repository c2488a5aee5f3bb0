package org.selectiverenderer.render.window;

/** A keyboard or mouse event. Positions are in pixels from the upper left corner, y downwards. */
public sealed interface InputEvent {

  /**
   * A key was pressed (repeatedly while it is held) or released.
   *
   * @param character the character that it produced when it was pressed, with line feed for Enter
   *     and backspace for Backspace; empty for keys that produce none
   * @param nanos when the window system reported it, as {@link System#nanoTime()}
   */
  record KeyInput(KeyboardKey key, boolean pressed, String character, long nanos)
      implements InputEvent {
    /** A key that produces no character, now. */
    public KeyInput(KeyboardKey key, boolean pressed) {
      this(key, pressed, "");
    }

    /** A key, now. */
    public KeyInput(KeyboardKey key, boolean pressed, String character) {
      this(key, pressed, character, System.nanoTime());
    }
  }

  /**
   * A mouse button was pressed or released.
   *
   * @param button 1 left, 2 middle, 3 right
   */
  record ButtonInput(int button, boolean pressed, int x, int y) implements InputEvent {}

  /**
   * The mouse moved.
   *
   * @param dx the movement since the last event, in the desktop's units, so that a hand's movement
   *     means the same on a display of double density; 0 when the pointer has just entered
   * @param dy likewise, downwards
   */
  record MotionInput(int x, int y, double dx, double dy) implements InputEvent {}

  /**
   * The wheel turned.
   *
   * @param notches the notches, positive away from the user
   */
  record WheelInput(float notches) implements InputEvent {}

  /** The window lost the keyboard focus: keys that are down will send no release events. */
  record FocusLost() implements InputEvent {}
}
