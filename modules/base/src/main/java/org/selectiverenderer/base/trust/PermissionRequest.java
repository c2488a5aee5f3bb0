package org.selectiverenderer.base.trust;

/**
 * One thing that a file asks for beyond its own folder.
 *
 * @param kind what is asked for
 * @param key the key of the file that asks
 * @param target what its value means on this computer: a path without links, a host, a device
 * @param meaning what the program would do, as a clause that follows the key
 */
public record PermissionRequest(Kind kind, String key, String target, String meaning) {
  /** The kinds of requests; those that reach farthest come first, and are shown first. */
  public enum Kind {
    /** Scenes may read a folder outside. */
    FOLDER,
    /** Scenes may fetch from a host. */
    HOST,
    /** A device is opened, or another program is connected to, for head tracking. */
    TRACKER,
    /** Data is sent to the network, or taken from it. */
    STREAM,
    /** Signals are sent to a device. */
    TRIGGER,
    /** A scene outside is shown, with what it may name there. */
    SCENE,
    /** A file outside is read. */
    FILE
  }

  /** Letters that fonts draw as nothing: an empty pattern of braille, and Hangul fillers. */
  private static final String BLANK_LETTERS = "\u2800\u3164\u115f\u1160\uffa0";

  /**
   * Returns the line that users read. Characters that could change how it looks, such as line ends,
   * escape sequences, marks of the writing direction and spaces but the usual one, are written as
   * codes.
   */
  @Override
  public String toString() {
    StringBuilder line = new StringBuilder();
    "\"%s\" %s".formatted(key, meaning).codePoints().forEach(sign -> append(line, sign));
    return line.toString();
  }

  private static void append(StringBuilder line, int sign) {
    if (sign == ' ') {
      line.append(' ');
      return;
    }
    if (BLANK_LETTERS.indexOf(sign) >= 0) {
      line.append("\\u{%x}".formatted(sign));
      return;
    }
    switch (Character.getType(sign)) {
      case Character.CONTROL,
          Character.FORMAT,
          Character.LINE_SEPARATOR,
          Character.PARAGRAPH_SEPARATOR,
          Character.SPACE_SEPARATOR,
          Character.SURROGATE,
          Character.PRIVATE_USE,
          Character.UNASSIGNED ->
          line.append("\\u{%x}".formatted(sign));
      default -> line.appendCodePoint(sign);
    }
  }
}
