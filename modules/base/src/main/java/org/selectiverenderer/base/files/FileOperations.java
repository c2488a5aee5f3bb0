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

/** The file system operations of a {@link FileTransaction}; tests override some to fail. */
public interface FileOperations {
  /** Operations of the real file system. */
  FileOperations REAL = new FileOperations() {};

  /** Operations of the real file system that create private files and folders. */
  FileOperations PRIVATE = new PrivateFileOperations(false);

  /** Operations that create private files and folders, and write through no link. */
  FileOperations PRIVATE_UNLINKED = new PrivateFileOperations(true);

  /** Returns the file that is written for a path: the target of a link. */
  default Path target(Path file) throws IOException {
    return TargetPaths.target(file);
  }

  /** Creates a folder in an existing one. */
  default void createFolder(Path folder) throws IOException {
    Files.createDirectory(folder);
  }

  /** Writes a new file and forces it to the disk, so that a full disk fails here. */
  default void write(Path file, byte[] content) throws IOException {
    try (FileChannel channel =
        FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
      DiskSync.write(channel, content);
      channel.force(true);
    }
  }

  /** Writes into an existing pipe or device; waits for the reader of a pipe. */
  default void pour(Path sink, byte[] content) throws IOException {
    try (OutputStream out = Files.newOutputStream(sink, StandardOpenOption.WRITE)) {
      out.write(content);
    }
  }

  /** Hard-links a file under a second name in its folder, or renames it where links are missing. */
  default void keep(Path file, Path as) throws IOException {
    try {
      Files.createLink(as, file);
    } catch (UnsupportedOperationException | FileSystemException e) {
      move(file, as);
    }
  }

  /** Renames a file within its folder, replacing any file of the new name. */
  default void move(Path from, Path to) throws IOException {
    try {
      Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /** Renames a file within its folder to a name that must be free. */
  default void place(Path from, Path to) throws IOException {
    Files.move(from, to);
  }

  /** Forces a folder's directory entries to the disk, as {@link DiskSync#forceFolder} does. */
  default void forceFolder(Path folder) throws IOException {
    DiskSync.forceFolder(folder);
  }

  /** Deletes a file or an empty folder. */
  default void delete(Path fileOrFolder) throws IOException {
    Files.deleteIfExists(fileOrFolder);
  }
}
