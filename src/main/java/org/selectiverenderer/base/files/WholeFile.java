package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/** One file written whole or not at all: at every moment there is all of the old or of the new. */
public final class WholeFile {
  private WholeFile() {}

  /** Replaces a file, or makes it; the rest as in {@link FileTransaction#add}. */
  public static void replace(Path file, byte[] content) throws IOException {
    replace(file, content, FileActions.REAL);
  }

  /**
   * The same by other actions.
   *
   * @throws NotWritten if it cannot be written, or its folder is not there: one that was unplugged
   *     is not made anew in its place. The file is as it was then
   */
  public static void replace(Path file, byte[] content, FileActions actions) throws IOException {
    requireFolder(file);
    FileTransaction writing = new FileTransaction(actions);
    writing.add(file, content);
    writing.commit();
  }

  /**
   * Replaces a file that the user named, or makes it. One whose name nothing can take though it may
   * be written to itself is written into: its folder is write-protected, or somebody else's with
   * others' files, or the file is a mount.
   *
   * @throws IOException with the file's name, if it cannot be written either way
   */
  public static void write(Path file, byte[] content) throws IOException {
    write(file, content, FileActions.REAL);
  }

  /** The same by other actions. */
  public static void write(Path file, byte[] content, FileActions actions) throws IOException {
    try {
      replace(file, content, actions);
    } catch (NotWritten e) {
      if (!keepsItsName(file, e)) {
        throw e;
      }
      writeInto(file, content);
    }
  }

  /** A full disk is no such reason. */
  private static boolean keepsItsName(Path file, NotWritten failure) {
    return failure.getCause() instanceof FileSystemException
        && Files.isRegularFile(file)
        && Files.isWritable(file);
  }

  /**
   * Writes into a file itself, so that who has it open sees the change; for what may be lost, such
   * as a picture of work that goes on.
   *
   * @throws IOException with the file's name
   */
  public static void writeInto(Path file, byte[] content) throws IOException {
    try {
      Files.write(file, content);
    } catch (IOException e) {
      throw NotWritten.named(file, e);
    }
  }

  /**
   * Writes a file that is never written again; after a power cut it is there with all its content
   * or not at all. One that is there with this very text was written before a crash, and stays.
   *
   * @throws NotWritten if it is there with another text, or cannot be written, or its folder is not
   *     there
   */
  public static void writeOnce(Path file, String text) throws IOException {
    requireFolder(file);
    FileTransaction writing = new FileTransaction();
    writing.addLasting(file, text.getBytes(StandardCharsets.UTF_8));
    writing.commit();
  }

  /** That of what a link is about, not the link's own. */
  private static void requireFolder(Path file) throws NotWritten {
    if (FileTransaction.sink(file)) {
      return; // What is behind a name such as /dev/stdout may be in no folder.
    }
    try {
      Path folder = FileNames.target(file).getParent();
      if (folder != null && !Files.isDirectory(folder)) {
        throw new IOException("its folder does not exist");
      }
    } catch (IOException e) {
      throw new NotWritten(file, e, FileTransaction.UNCHANGED);
    }
  }
}
