package org.selectiverenderer.base.files;

import java.nio.charset.StandardCharsets;

/** Shortens names of files to what file systems take. */
public final class FileNameLength {
  /** The bytes of UTF-8 in the longest name on Linux; macOS and Windows take as many characters. */
  static final int MOST_BYTES = 255;

  private FileNameLength() {}

  /**
   * Returns the start of a name that leaves room for an ending; a name that fits is unchanged.
   *
   * @param ending the number of bytes that are to be added
   */
  public static String shortened(String name, int ending) {
    int bytes = 0;
    for (int i = 0; i < name.length(); i += Character.charCount(name.codePointAt(i))) {
      String character = Character.toString(name.codePointAt(i));
      bytes += character.getBytes(StandardCharsets.UTF_8).length;
      if (bytes > MOST_BYTES - ending) {
        return name.substring(0, i);
      }
    }
    return name;
  }
}
