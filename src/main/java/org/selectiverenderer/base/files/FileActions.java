package org.selectiverenderer.base.files;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/** What is done to files, as the file system does it; a test has some of it fail. */
public interface FileActions {
  /** The file system's own. */
  FileActions REAL = new FileActions() {};

  /** Makes a folder in one that is there. */
  default void createFolder(Path folder) throws IOException {
    Files.createDirectory(folder);
  }

  /** Writes a new file to the disk itself, not to a cache that may still fail. */
  default void write(Path file, byte[] content) throws IOException {
    try (FileChannel channel =
        FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
      Disk.write(channel, content);
      channel.force(true);
    }
  }

  /** Writes into what exists and is no file of a disk, such as a pipe; waits for its reader. */
  default void pour(Path sink, byte[] content) throws IOException {
    try (OutputStream out = Files.newOutputStream(sink, StandardOpenOption.WRITE)) {
      out.write(content);
    }
  }

  /** Gives a file a second name in its folder; where a disk has no links, it loses the first. */
  default void keep(Path file, Path as) throws IOException {
    try {
      Files.createLink(as, file);
    } catch (UnsupportedOperationException | FileSystemException e) {
      move(file, as);
    }
  }

  /** Gives a file another name in its folder, in place of what had it. */
  default void move(Path from, Path to) throws IOException {
    try {
      Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /** Gives a file another name in its folder, which nothing may have. */
  default void place(Path from, Path to) throws IOException {
    Files.move(from, to);
  }

  /** Has the disk keep a folder's list of names, as {@link Disk#forceFolder}. */
  default void forceFolder(Path folder) throws IOException {
    Disk.forceFolder(folder);
  }

  /** Deletes a file or an empty folder. */
  default void delete(Path fileOrFolder) throws IOException {
    Files.deleteIfExists(fileOrFolder);
  }
}
