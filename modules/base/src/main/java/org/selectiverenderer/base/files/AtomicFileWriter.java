package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes one file atomically: a reader sees the complete old or the complete new content. */
public final class AtomicFileWriter {
  private AtomicFileWriter() {}

  /** Replaces or creates a file; links and permissions as in {@link FileTransaction#add}. */
  public static void replace(Path file, byte[] content) throws IOException {
    replace(file, content, FileOperations.REAL);
  }

  /**
   * Replaces or creates a file by the given file operations.
   *
   * @throws FileWriteException if it cannot be written, or its folder does not exist (the folder is
   *     not created, as it may be on an unplugged drive); the file is then unchanged
   */
  public static void replace(Path file, byte[] content, FileOperations actions) throws IOException {
    requireFolder(file);
    FileTransaction writing = new FileTransaction(actions);
    writing.add(file, content);
    writing.commit();
  }

  /**
   * Replaces or creates a file that the user named. A file that is writable but cannot be replaced
   * is written in place instead: its folder is write-protected or sticky, or the file is a mount
   * point.
   *
   * @throws IOException with the file's name, if it cannot be written either way
   */
  public static void write(Path file, byte[] content) throws IOException {
    write(file, content, FileOperations.REAL);
  }

  /** Replaces or creates a file in the same way by the given file operations. */
  public static void write(Path file, byte[] content, FileOperations actions) throws IOException {
    try {
      replace(file, content, actions);
    } catch (FileWriteException e) {
      if (!keepsItsName(file, e)) {
        throw e;
      }
      writeInto(file, content);
    }
  }

  /** Returns whether the file is writable but cannot be replaced; a full disk is no such case. */
  private static boolean keepsItsName(Path file, FileWriteException failure) {
    return failure.getCause() instanceof FileSystemException
        && Files.isRegularFile(file)
        && Files.isWritable(file);
  }

  /**
   * Writes a file in place, so that a program that has it open sees the change; not atomic, for
   * content that may be lost, such as a picture of a computation in progress.
   *
   * @throws IOException with the file's name
   */
  public static void writeInto(Path file, byte[] content) throws IOException {
    try {
      Files.write(file, content);
    } catch (IOException e) {
      throw FileWriteException.named(file, e);
    }
  }

  /**
   * Writes a file once; after a power cut it exists with all its content or not at all. An existing
   * file with the same text, written before a crash, is kept.
   *
   * @throws FileWriteException if the file exists with another text, cannot be written, or its
   *     folder does not exist
   */
  public static void writeOnce(Path file, String text) throws IOException {
    writeOnce(file, text, FileOperations.REAL);
  }

  /** Writes a file once in the same way by the given file operations. */
  public static void writeOnce(Path file, String text, FileOperations actions) throws IOException {
    requireFolder(file);
    FileTransaction writing = new FileTransaction(actions);
    writing.addLasting(file, text.getBytes(StandardCharsets.UTF_8));
    writing.commit();
  }

  /** Requires the folder of the file, for a link that of its target, to exist. */
  private static void requireFolder(Path file) throws FileWriteException {
    if (FileTransaction.sink(file)) {
      return; // the target of a name such as /dev/stdout may be in no folder
    }
    try {
      Path folder = TargetPaths.target(file).getParent();
      if (folder != null && !Files.isDirectory(folder)) {
        throw new IOException("its folder does not exist");
      }
    } catch (IOException e) {
      throw new FileWriteException(file, e, FileTransaction.UNCHANGED);
    }
  }
}
