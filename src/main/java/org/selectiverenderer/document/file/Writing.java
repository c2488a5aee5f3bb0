package org.selectiverenderer.document.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileActions;
import org.selectiverenderer.base.files.NotWritten;
import org.selectiverenderer.base.files.WholeFile;
import org.selectiverenderer.document.Snapshot;

/**
 * A document on its way to a file: what is to be written is settled, so any one thread may write
 * it. {@link DocumentFile#written} tells the document afterwards.
 */
public final class Writing {
  private final FileActions actions;
  private final Path target;
  private final Snapshot snapshot;
  private final DocumentFile.@Nullable Guard guard;
  private @Nullable FileStamp stamp;

  Writing(FileActions actions, Path target, Snapshot snapshot, DocumentFile.@Nullable Guard guard) {
    this.actions = actions;
    this.target = target;
    this.snapshot = snapshot;
    this.guard = guard;
  }

  /** The file. */
  public Path target() {
    return target;
  }

  Snapshot snapshot() {
    return snapshot;
  }

  @Nullable FileStamp stamp() {
    return stamp;
  }

  /** The same, whatever somebody else has written into the file; that goes to the backup. */
  public Writing over() {
    return new Writing(actions, target, snapshot, null);
  }

  /**
   * Writes the file and its backup.
   *
   * @throws FileChanged if somebody else has written the file
   * @throws IOException if it cannot be written, with one line that names it and says what to do
   */
  public void write() throws IOException {
    if (guard != null && guard.state() == DiskState.CHANGED) {
      throw new FileChanged(
          target
              + ": another program has changed the file since it was opened; it is not overwritten");
    }
    byte[] bytes = snapshot.bytes();
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
    Path backup = DocumentFile.backup(target);
    byte[] old = Files.readAllBytes(target);
    try {
      WholeFile.replace(backup, old, actions);
    } catch (NotWritten e) {
      throw new IOException(
          "no backup can be kept as %s: %s".formatted(backup.getFileName(), e.reason()), e);
    }
  }
}
