package org.selectiverenderer.runtime.render.window;

/** The characters that keys produce, as sensors of a scene are told them. */
final class KeyCharacters {
  private KeyCharacters() {}

  /**
   * The character of a key that goes down; empty where it produces none.
   *
   * @param typed what the window system says, which with Control held is a control character
   */
  static String of(KeyboardKey key, char typed) {
    return switch (key) {
      case ENTER -> "\n";
      case TAB -> "\t";
      case BACKSPACE -> "\b";
      case DELETE -> "\u007f";
      case SPACE -> " ";
      default -> {
        if (key.special()) {
          yield "";
        }
        boolean produced = Character.isDefined(typed) && !Character.isISOControl(typed);
        yield produced ? String.valueOf(typed) : key.letter();
      }
    };
  }
}
