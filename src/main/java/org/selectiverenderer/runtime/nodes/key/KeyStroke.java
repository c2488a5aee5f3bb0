package org.selectiverenderer.runtime.nodes.key;

/**
 * A key went down or up. One that is held may go down again and again.
 *
 * @param pressed whether it went down
 */
public record KeyStroke(Key key, boolean pressed) {
  /** The text of the key that ends a line. */
  public static final String ENTER = "\n";

  /** The text of the key that deletes the character before. */
  public static final String BACKSPACE = "\b";

  /** A key as a key device sensor tells it. */
  public sealed interface Key {}

  /**
   * A key that produces a character.
   *
   * @param text the character that it produced when it went down, also when it goes up
   */
  public record Character(String text) implements Key {}

  /** The keys that produce none, with their numbers (X3D 4.0, 21.4.1). */
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

    /** Whether it is a function key. */
    public boolean function() {
      return compareTo(F12) <= 0;
    }
  }

  /** The keys that change what others mean. */
  public enum Modifier implements Key {
    SHIFT,
    CONTROL,
    ALT
  }
}
