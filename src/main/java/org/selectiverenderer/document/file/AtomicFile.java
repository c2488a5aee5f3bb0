package org.selectiverenderer.document.file;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import org.selectiverenderer.polygon.versions.FileActions;

/**
 * Writes a file so that at every moment there is either all of the old or all of the new one: the
 * content goes to a temporary file beside it, onto the disk itself, and then takes the name.
 */
final class AtomicFile {
  private final FileActions actions;

  AtomicFile(FileActions actions) {
    this.actions = actions;
  }

  /**
   * @param file written; a symbolic link stays one, and what it names is replaced
   * @throws IOException if it cannot be written, with the first half of a sentence; it is as it was
   */
  void write(Path file, byte[] content) throws IOException {
    Path target = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath().normalize();
    if (Files.isDirectory(target)) {
      throw new IOException("it is a folder");
    }
    if (Files.exists(target) && !Files.isWritable(target)) {
      throw new IOException("it is write-protected");
    }
    if (Files.exists(target) && !Files.isRegularFile(target)) {
      pour(target, content);
      return;
    }
    Path temporary = beside(target);
    try {
      actions.write(temporary, content);
      copyPermissions(target, temporary);
      actions.move(temporary, target);
    } catch (IOException e) {
      IOException told = new IOException(reason(e), e);
      try {
        actions.delete(temporary);
      } catch (IOException left) {
        told.addSuppressed(left);
      }
      throw told;
    }
  }

  /** Into a pipe or a device, which has no old content and must keep its name. */
  private void pour(Path sink, byte[] content) throws IOException {
    try {
      actions.pour(sink, content);
    } catch (IOException e) {
      throw new IOException(reason(e), e);
    }
  }

  private static Path beside(Path target) {
    for (int i = 0; ; i++) {
      Path name = target.resolveSibling("." + target.getFileName() + ".new" + i);
      if (Files.notExists(name)) {
        return name;
      }
    }
  }

  private static void copyPermissions(Path from, Path to) throws IOException {
    PosixFileAttributeView old = Files.getFileAttributeView(from, PosixFileAttributeView.class);
    PosixFileAttributeView made = Files.getFileAttributeView(to, PosixFileAttributeView.class);
    if (old != null && made != null && Files.exists(from) && Files.exists(to)) {
      made.setPermissions(old.readAttributes().permissions());
    }
  }

  private static String reason(IOException e) {
    if (e instanceof AccessDeniedException) {
      return "permission denied";
    }
    if (e instanceof FileSystemException file && file.getReason() != null) {
      return file.getReason();
    }
    if (e instanceof NoSuchFileException) {
      return "its folder is not there";
    }
    return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
  }
}
