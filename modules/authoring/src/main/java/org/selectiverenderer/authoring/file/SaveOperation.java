package org.selectiverenderer.authoring.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileWriteException;

/**
 * The operation that saves a document to a file. Its content is fixed, so that any thread may
 * execute it; afterwards the document is informed by {@link DocumentFile#written}.
 */
public final class SaveOperation {
  private final FileOperations actions;
  private final Path target;
  private final Text text;
  private final @Nullable Before before;
  private @Nullable FileFingerprint stamp;

  /**
   * The text to be written.
   *
   * @param sound whether it is well-formed
   */
  record Text(DocumentSnapshot snapshot, boolean sound) {}

  /**
   * The existing file that is expected.
   *
   * @param sound whether it is well-formed
   */
  record Before(DocumentFile.ChangeGuard guard, boolean sound) {}

  /**
   * @param before null to replace any existing file
   */
  SaveOperation(FileOperations actions, Path target, Text text, @Nullable Before before) {
    this.actions = actions;
    this.target = target;
    this.text = text;
    this.before = before;
  }

  /** Returns the target file. */
  public Path target() {
    return target;
  }

  Text text() {
    return text;
  }

  @Nullable FileFingerprint stamp() {
    return stamp;
  }

  /**
   * Returns an operation that overwrites changes of other programs, which are kept in the backup.
   */
  public SaveOperation over() {
    return new SaveOperation(actions, target, text, null);
  }

  /**
   * Writes the file and its backup.
   *
   * @throws FileChangedException if another program has written the file
   * @throws IOException if it cannot be written, with a one-line message that names it and says
   *     what to do
   */
  public void write() throws IOException {
    if (before != null && before.guard().state() == FileState.CHANGED) {
      throw new FileChangedException(
          target
              + ": another program has changed the file since it was opened; it is not overwritten");
    }
    byte[] bytes = text.snapshot().bytes();
    try {
      if (Files.isRegularFile(target)) {
        backUp();
      }
      AtomicFileWriter.replace(target, bytes, actions);
    } catch (IOException e) {
      throw new IOException(
          "%s: cannot be saved (%s); file and document are as they were. Save it under another name"
              .formatted(target, e instanceof FileWriteException it ? it.reason() : e.getMessage()),
          e);
    }
    stamp = FileFingerprint.of(target, bytes);
  }

  private void backUp() throws IOException {
    byte[] old = Files.readAllBytes(target);
    boolean sound = before != null ? before.sound() : sound(old);
    Path backup = DocumentFile.backup(target, sound);
    try {
      AtomicFileWriter.replace(backup, old, actions);
    } catch (FileWriteException e) {
      throw new IOException(
          "no backup can be kept as %s: %s".formatted(backup.getFileName(), e.reason()), e);
    }
  }

  /** Returns whether bytes are a well-formed text. */
  private static boolean sound(byte[] bytes) {
    try {
      return SceneDocument.of("", bytes).fault().isEmpty();
    } catch (IOException e) {
      return false; // not a text; it is backed up nevertheless
    }
  }
}
