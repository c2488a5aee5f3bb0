package org.selectiverenderer.browser.nodes.keyboard;

/**
 * A key event: a key went down or up. A held key may go down repeatedly.
 *
 * @param pressed whether the key went down
 */
public record KeyboardEvent(Key key, boolean pressed) {
  /** The text of the Enter key. */
  public static final String ENTER = "\n";

  /** The text of the Backspace key. */
  public static final String BACKSPACE = "\b";

  /** A key as key device sensors distinguish it. */
  public sealed interface Key {}

  /**
   * A key that produces a character.
   *
   * @param text the character produced when the key went down; the same when it goes up
   */
  public record Character(String text) implements Key {}

  /** The action keys, which produce no character, with their numbers (X3D 4.0, 21.4.1). */
  public enum Action implements Key {
    F1,
    F2,
    F3,
    F4,
    F5,
    F6,
    F7,
    F8,
    F9,
    F10,
    F11,
    F12,
    HOME,
    END,
    PAGE_UP,
    PAGE_DOWN,
    UP,
    DOWN,
    LEFT,
    RIGHT;

    int code() {
      return ordinal() + 1;
    }

    /** Returns whether this is a function key. */
    public boolean function() {
      return compareTo(F12) <= 0;
    }
  }

  /** The modifier keys. */
  public enum Modifier implements Key {
    SHIFT,
    CONTROL,
    ALT
  }
}
