package org.selectiverenderer.polygon.versions;

import java.io.IOException;
import java.nio.file.Path;

/** What is done to files: the file system's own, or one that fails in a test. */
public interface FileActions {
  /** The real ones. */
  FileActions REAL = new RealFileActions();

  void createFolder(Path folder) throws IOException;

  /** Writes a new file to the disk itself, not to a cache that may still fail. */
  void write(Path file, byte[] content) throws IOException;

  /** Gives a file another name in its folder, in place of what had it. */
  void move(Path from, Path to) throws IOException;

  void delete(Path fileOrFolder) throws IOException;
}
