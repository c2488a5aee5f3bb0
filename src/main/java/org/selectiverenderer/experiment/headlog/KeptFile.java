package org.selectiverenderer.experiment.headlog;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;

/**
 * Files of a study that are written once, whole, and forced to the disk: after a power cut they are
 * there with all their content or not at all.
 */
public final class KeptFile {
  private KeptFile() {}

  /**
   * Writes a file that is never written again. One that is there with this very text was written
   * before a crash, and stays.
   *
   * @throws IOException if it is there with another text, or cannot be written
   */
  public static void write(Path file, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    if (Files.exists(file)) {
      same(file, bytes);
      return;
    }
    // Not a temporary file of Java's, which nobody but its owner may read.
    Path half = file.resolveSibling(file.getFileName() + ".part");
    try {
      try (FileChannel channel =
          FileChannel.open(
              half,
              StandardOpenOption.CREATE,
              StandardOpenOption.TRUNCATE_EXISTING,
              StandardOpenOption.WRITE)) {
        ByteBuffer left = ByteBuffer.wrap(bytes);
        while (left.hasRemaining()) {
          channel.write(left);
        }
        channel.force(true);
      }
      // Does not replace what another program may have written meanwhile.
      Files.move(half, file);
      forceFolder(file.getParent());
    } catch (FileAlreadyExistsException e) {
      same(file, bytes);
    } catch (IOException e) {
      throw named(file, e);
    } finally {
      Files.deleteIfExists(half);
    }
  }

  /** A full disk does not say for which file. */
  static IOException named(Path file, IOException e) {
    return e instanceof FileSystemException ? e : new IOException(file + ": " + e.getMessage(), e);
  }

  private static void same(Path file, byte[] bytes) throws IOException {
    if (!Arrays.equals(Files.readAllBytes(file), bytes)) {
      throw new IOException(file + " is there with other content; nothing is written over");
    }
  }

  /**
   * Has the disk keep a folder's list of names, without which a new file is lost with its content
   * (POSIX: fsync of a file does not do it). Windows keeps names by itself and opens no folder.
   *
   * @throws IOException if the disk fails
   */
  public static void forceFolder(Path folder) throws IOException {
    if (folder.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
        channel.force(true);
      }
    }
  }
}
