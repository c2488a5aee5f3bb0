package org.selectiverenderer.document.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileActions;
import org.selectiverenderer.base.files.NotWritten;
import org.selectiverenderer.base.files.WholeFile;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.document.Snapshot;

/**
 * A document on its way to a file: what is to be written is settled, so any one thread may write
 * it. {@link DocumentFile#written} tells the document afterwards.
 */
public final class Writing {
  private final FileActions actions;
  private final Path target;
  private final Text text;
  private final @Nullable Before before;
  private @Nullable FileStamp stamp;

  /**
   * What is written.
   *
   * @param sound whether it is well formed
   */
  record Text(Snapshot snapshot, boolean sound) {}

  /**
   * The file that is expected there.
   *
   * @param sound whether it is well formed
   */
  record Before(DocumentFile.Guard guard, boolean sound) {}

  /**
   * @param before null where it is replaced whatever it is
   */
  Writing(FileActions actions, Path target, Text text, @Nullable Before before) {
    this.actions = actions;
    this.target = target;
    this.text = text;
    this.before = before;
  }

  /** The file. */
  public Path target() {
    return target;
  }

  Text text() {
    return text;
  }

  @Nullable FileStamp stamp() {
    return stamp;
  }

  /** The same, whatever somebody else has written into the file; that goes to the backup. */
  public Writing over() {
    return new Writing(actions, target, text, null);
  }

  /**
   * Writes the file and its backup.
   *
   * @throws FileChanged if somebody else has written the file
   * @throws IOException if it cannot be written, with one line that names it and says what to do
   */
  public void write() throws IOException {
    if (before != null && before.guard().state() == DiskState.CHANGED) {
      throw new FileChanged(
          target
              + ": another program has changed the file since it was opened; it is not overwritten");
    }
    byte[] bytes = text.snapshot().bytes();
    try {
      if (Files.isRegularFile(target)) {
        backUp();
      }
      WholeFile.replace(target, bytes, actions);
    } catch (IOException e) {
      throw new IOException(
          "%s: cannot be saved (%s); file and document are as they were. Save it under another name"
              .formatted(target, e instanceof NotWritten it ? it.reason() : e.getMessage()),
          e);
    }
    stamp = FileStamp.of(target, bytes);
  }

  private void backUp() throws IOException {
    byte[] old = Files.readAllBytes(target);
    boolean sound = before != null ? before.sound() : sound(old);
    Path backup = DocumentFile.backup(target, sound);
    try {
      WholeFile.replace(backup, old, actions);
    } catch (NotWritten e) {
      throw new IOException(
          "no backup can be kept as %s: %s".formatted(backup.getFileName(), e.reason()), e);
    }
  }

  /** Whether bytes are a text that is well formed. */
  private static boolean sound(byte[] bytes) {
    try {
      return SceneDocument.of("", bytes).fault().isEmpty();
    } catch (IOException e) {
      return false; // no text at all; it is kept all the same
    }
  }
}
