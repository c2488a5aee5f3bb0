package org.selectiverenderer.polygon.versions;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** What is done to files: the file system's own, or one that fails in a test. */
public interface FileActions {
  /** The real ones. */
  FileActions REAL = new RealFileActions();

  void createFolder(Path folder) throws IOException;

  /** Writes a new file to the disk itself, not to a cache that may still fail. */
  void write(Path file, byte[] content) throws IOException;

  /** Writes into what exists and is no file of a disk, such as a pipe; waits for its reader. */
  default void pour(Path sink, byte[] content) throws IOException {
    try (OutputStream out = Files.newOutputStream(sink, StandardOpenOption.WRITE)) {
      out.write(content);
    }
  }

  /** Gives a file another name in its folder, in place of what had it. */
  void move(Path from, Path to) throws IOException;

  void delete(Path fileOrFolder) throws IOException;
}
