package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** Forces file content and directory entries to the disk, so that they survive a power cut. */
public final class DiskSync {
  private DiskSync() {}

  /** Writes all bytes at the channel's position; the caller's {@code force} makes them durable. */
  public static void write(FileChannel channel, byte[] content) throws IOException {
    ByteBuffer left = ByteBuffer.wrap(content);
    while (left.hasRemaining()) {
      channel.write(left);
    }
  }

  /**
   * Forces a folder's directory entries to the disk, without which a new file may be lost (on
   * POSIX, fsync of the file does not sync its name). Windows does so by itself and cannot open a
   * folder.
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
