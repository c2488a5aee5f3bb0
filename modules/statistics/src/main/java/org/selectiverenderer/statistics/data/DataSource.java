package org.selectiverenderer.statistics.data;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.selectiverenderer.base.files.Sha256;

/**
 * The source of data. Reports name it with its hash, so that a reader can tell which data they
 * describe.
 *
 * @param name name of the file, without its folder
 * @param sha256 SHA-256 of the file as it was read, 64 hexadecimal digits; empty for data that are
 *     not from a file
 */
public record DataSource(String name, Optional<String> sha256) {
  /** Returns the source of data that were read from a file. */
  public static DataSource of(String name, byte[] content) {
    return new DataSource(name, Optional.of(Sha256.of(content)));
  }

  /** Returns the source of data given as text, hashed as a file in UTF-8. */
  static DataSource of(String name, String text) {
    return of(name, text.getBytes(StandardCharsets.UTF_8));
  }

  /** Returns the source of data that are not from a file. */
  public static DataSource none(String name) {
    return new DataSource(name, Optional.empty());
  }
}
