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
  /** The kinds of requests. */
  public enum Kind {
    /** A scene outside is shown, with what it may name there. */
    SCENE,
    /** A file outside is read. */
    FILE,
    /** Scenes may read a folder outside. */
    FOLDER,
    /** Scenes may fetch from a host. */
    HOST,
    /** A device is opened, or another program is connected to, for head tracking. */
    TRACKER,
    /** Data is sent to the network, or taken from it. */
    STREAM
  }

  /**
   * Returns the line that users read. Characters that could change how it looks, such as line ends,
   * escape sequences and marks of the writing direction, are written as codes.
   */
  @Override
  public String toString() {
    StringBuilder line = new StringBuilder();
    "\"%s\" %s".formatted(key, meaning).codePoints().forEach(sign -> append(line, sign));
    return line.toString();
  }

  private static void append(StringBuilder line, int sign) {
    switch (Character.getType(sign)) {
      case Character.CONTROL,
          Character.FORMAT,
          Character.LINE_SEPARATOR,
          Character.PARAGRAPH_SEPARATOR,
          Character.SURROGATE,
          Character.PRIVATE_USE,
          Character.UNASSIGNED ->
          line.append("\\u{%x}".formatted(sign));
      default -> line.appendCodePoint(sign);
    }
  }
}
