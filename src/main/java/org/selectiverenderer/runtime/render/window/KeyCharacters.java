package org.selectiverenderer.runtime.render.window;

/** The characters that keys produce, as KeySensor and StringSensor need them. */
final class KeyCharacters {
  private KeyCharacters() {}

  /**
   * Returns the character of a key that is pressed; empty where it produces none.
   *
   * @param typed the character that the window system reports, a control character while Control is
   *     held
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
