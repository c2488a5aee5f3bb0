package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** What a power cut must not take. */
public final class Disk {
  private Disk() {}

  /** Writes all of it at the channel's position; {@code force} has the disk keep it. */
  public static void write(FileChannel channel, byte[] content) throws IOException {
    ByteBuffer left = ByteBuffer.wrap(content);
    while (left.hasRemaining()) {
      channel.write(left);
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
