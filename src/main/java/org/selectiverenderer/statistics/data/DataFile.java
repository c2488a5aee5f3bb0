package org.selectiverenderer.statistics.data;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.selectiverenderer.base.files.Sha256;

/**
 * Where data come from, so that a report says of which bytes it is.
 *
 * @param name of the file, without its folder
 * @param sha256 of the file as it was read, 64 hexadecimal digits; empty for data that are no file
 */
public record DataFile(String name, Optional<String> sha256) {
  /** A file that was read. */
  public static DataFile of(String name, byte[] content) {
    return new DataFile(name, Optional.of(Sha256.of(content)));
  }

  /** A text that was or might be such a file in UTF-8. */
  static DataFile of(String name, String text) {
    return of(name, text.getBytes(StandardCharsets.UTF_8));
  }

  /** Data that are no file. */
  public static DataFile none(String name) {
    return new DataFile(name, Optional.empty());
  }
}
