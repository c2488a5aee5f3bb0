package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads files that a user names; reading a folder fails with a clear message. */
public final class InputFileReader {
  private InputFileReader() {}

  /**
   * Returns a file's bytes.
   *
   * @throws IOException if it cannot be read, or is a folder
   */
  public static byte[] bytes(Path path) throws IOException {
    noFolder(path);
    return Files.readAllBytes(path);
  }

  /**
   * Returns a file's text, decoded from UTF-8.
   *
   * @throws IOException if it cannot be read, is a folder, or is not UTF-8
   */
  public static String text(Path path) throws IOException {
    noFolder(path);
    return Files.readString(path, StandardCharsets.UTF_8);
  }

  private static void noFolder(Path path) throws FileSystemException {
    if (Files.isDirectory(path)) {
      throw new FileSystemException(path.toString(), null, "is a folder, not a file");
    }
  }
}
