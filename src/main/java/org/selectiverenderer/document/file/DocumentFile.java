package org.selectiverenderer.document.file;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.polygon.versions.FileActions;

/**
 * A document and the file that it comes from. Saving keeps the file as it was before in a backup
 * beside it, replaces it in one moment, and refuses to overwrite what somebody else has written
 * meanwhile. Whatever fails, document and file are as they were.
 */
public final class DocumentFile {
  private final FileActions actions;
  private final SceneDocument document;
  private Path path;
  private @Nullable Stamp stamp;

  private DocumentFile(
      FileActions actions, SceneDocument document, Path path, @Nullable Stamp stamp) {
    this.actions = actions;
    this.document = document;
    this.path = path;
    this.stamp = stamp;
  }

  /** Opens a file. */
  public static DocumentFile open(Path path) throws IOException {
    return open(path, FileActions.REAL);
  }

  /**
   * Opens a file.
   *
   * @throws IOException if it cannot be read, with one line that names it
   */
  public static DocumentFile open(Path path, FileActions actions) throws IOException {
    if (Files.isDirectory(path)) {
      throw new IOException(path + ": this is a folder, not a scene");
    }
    byte[] bytes;
    Stamp stamp;
    try {
      bytes = Files.readAllBytes(path);
      stamp = Stamp.of(path, bytes);
    } catch (NoSuchFileException e) {
      throw new IOException(path + ": there is no such file", e);
    } catch (AccessDeniedException e) {
      throw new IOException(path + ": the file may not be read", e);
    }
    return new DocumentFile(actions, SceneDocument.of(path.toString(), bytes), path, stamp);
  }

  /** A document that is in no file yet, such as one that was recovered and whose file is gone. */
  static DocumentFile unsaved(Path path, SceneDocument document) {
    document.markUnsaved();
    return new DocumentFile(FileActions.REAL, document, path, null);
  }

  public SceneDocument document() {
    return document;
  }

  /** Where it was saved last, or opened. */
  public Path path() {
    return path;
  }

  /** Where the file as it was before the last saving is kept. */
  public Path backup() {
    return path.resolveSibling(path.getFileName() + ".bak");
  }

  /** What has become of the file since. */
  public DiskState state() throws IOException {
    return stamp == null
        ? (Files.exists(path) ? DiskState.CHANGED : DiskState.GONE)
        : stamp.compare(path);
  }

  /**
   * Writes the document to its file.
   *
   * @throws FileChanged if somebody else has written the file; {@link #saveOver} does it all the
   *     same
   * @throws IOException if it cannot be written, with one line that names it and says what to do
   */
  public void save() throws IOException {
    if (state() == DiskState.CHANGED) {
      throw new FileChanged(
          path
              + ": another program has changed the file since it was opened; it is not overwritten");
    }
    saveOver();
  }

  /** Writes the document to its file, whatever is there now; that goes to the backup. */
  public void saveOver() throws IOException {
    write(path);
    document.markSaved();
  }

  /** Writes the document to another file, which is its file from now on. */
  public void saveAs(Path other) throws IOException {
    write(other);
    path = other;
    document.markSaved();
  }

  private void write(Path target) throws IOException {
    byte[] bytes = document.bytes();
    AtomicFile writing = new AtomicFile(actions);
    try {
      if (Files.isRegularFile(target)) {
        Path old = target.resolveSibling(target.getFileName() + ".bak");
        writing.write(old, Files.readAllBytes(target));
      }
      writing.write(target, bytes);
    } catch (IOException e) {
      throw new IOException(
          "%s: cannot be saved (%s); file and document are as they were. Save it under another name"
              .formatted(target, e.getMessage()),
          e);
    }
    stamp = Stamp.of(target, bytes);
  }
}
