package org.selectiverenderer.base.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Reads files that a user, or a file of somebody else, names. Only regular files are read: a device
 * such as {@code /dev/zero} never ends, and a pipe may never begin.
 */
public final class InputFileReader {
  /** More than hours of any recording; what is longer is no file for this program. */
  private static final int MOST_BYTES = 1 << 30;

  private InputFileReader() {}

  /**
   * Returns a file's bytes.
   *
   * @throws IOException if it cannot be read, is no regular file, or too long
   */
  public static byte[] bytes(Path path) throws IOException {
    return bytes(path, MOST_BYTES);
  }

  static byte[] bytes(Path path, int most) throws IOException {
    requireRegular(path);
    if (Files.size(path) > most) {
      throw tooLong(path, most);
    }
    try (InputStream in = Files.newInputStream(path)) {
      byte[] bytes = in.readNBytes(most);
      if (bytes.length == most && in.read() >= 0) { // some files of the system have no size
        throw tooLong(path, most);
      }
      return bytes;
    }
  }

  /**
   * Returns a file's text, decoded from UTF-8.
   *
   * @throws IOException if it cannot be read, is no regular file, too long, or not UTF-8
   */
  public static String text(Path path) throws IOException {
    return StandardCharsets.UTF_8
        .newDecoder()
        .onMalformedInput(CodingErrorAction.REPORT)
        .onUnmappableCharacter(CodingErrorAction.REPORT)
        .decode(ByteBuffer.wrap(bytes(path)))
        .toString();
  }

  /**
   * Requires a path to be a regular file, or a link to one.
   *
   * @throws IOException if it is a folder, a device or a pipe
   */
  public static void requireRegular(Path path) throws IOException {
    if (Files.isDirectory(path)) {
      throw new FileSystemException(path.toString(), null, "is a folder, not a file");
    }
    if (Files.exists(path) && !Files.isRegularFile(path)) {
      throw new FileSystemException(
          path.toString(), null, "is a device or a pipe, not a file; save what it gives in a file");
    }
  }

  private static IOException tooLong(Path path, int most) {
    return new FileSystemException(
        path.toString(), null, "is longer than %d MB".formatted(Math.max(1, most >> 20)));
  }
}
