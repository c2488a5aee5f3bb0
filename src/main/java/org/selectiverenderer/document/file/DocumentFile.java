package org.selectiverenderer.document.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileActions;
import org.selectiverenderer.document.SceneDocument;

/**
 * A document and the file that it comes from. Saving keeps the file as it was before in a backup
 * beside it (one that was not well formed in a backup of its own, so that the last good copy
 * stays), replaces it in one moment, and refuses to overwrite what somebody else has written
 * meanwhile. Whatever fails, document and file are as they were.
 */
public final class DocumentFile {
  private final FileActions actions;
  private final SceneDocument document;
  private Path path;
  private @Nullable FileStamp stamp;

  /** Whether the file's text, as it was opened or saved last, is well formed. */
  private boolean sound;

  private DocumentFile(
      FileActions actions, SceneDocument document, Path path, @Nullable FileStamp stamp) {
    this.actions = actions;
    this.document = document;
    this.path = path;
    this.stamp = stamp;
    this.sound = document.fault().isEmpty();
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
    FileStamp stamp;
    try {
      bytes = Files.readAllBytes(path);
      stamp = FileStamp.of(path, bytes);
    } catch (NoSuchFileException e) {
      throw new IOException(path + ": the file does not exist", e);
    } catch (AccessDeniedException e) {
      throw new IOException(path + ": no permission to read the file", e);
    }
    return new DocumentFile(actions, SceneDocument.of(path.toString(), bytes), path, stamp);
  }

  /** A document that is in no file yet, such as one that was recovered and whose file is gone. */
  static DocumentFile unsaved(Path path, SceneDocument document) {
    document.markUnsaved();
    return new DocumentFile(FileActions.REAL, document, path, null);
  }

  /**
   * Opens a text that has been made of another file.
   *
   * @param path where it is to be saved
   */
  public static DocumentFile made(Path path, String text) throws IOException {
    return unsaved(path, SceneDocument.of(path.toString(), text.getBytes(StandardCharsets.UTF_8)));
  }

  public SceneDocument document() {
    return document;
  }

  /** Where it was saved last, or opened. */
  public Path path() {
    return path;
  }

  /** Where the file as it was before the last saving is kept, the last that was well formed. */
  public Path backup() {
    return backup(path, true);
  }

  /** Where a file that was not well formed is kept, so that it never takes the other's place. */
  public Path faultyBackup() {
    return backup(path, false);
  }

  static Path backup(Path file, boolean sound) {
    return file.resolveSibling(file.getFileName() + (sound ? ".bak" : ".faulty.bak"));
  }

  private static DiskState state(Path file, @Nullable FileStamp stamp) throws IOException {
    return stamp == null
        ? (Files.exists(file) ? DiskState.CHANGED : DiskState.GONE)
        : stamp.compare(file);
  }

  /** Tells whether somebody else has written a file; any thread may ask. */
  @FunctionalInterface
  public interface Guard {
    DiskState state() throws IOException;
  }

  /** Tells what becomes of the file from now on. */
  public Guard guard() {
    Path file = path;
    FileStamp expected = stamp;
    return () -> state(file, expected);
  }

  /** The document as it is now, to be written to its file by any thread. */
  public Writing writing() {
    return new Writing(actions, path, text(), new Writing.Before(guard(), sound));
  }

  /** The same, to another file, which is the document's from {@link #written} on. */
  public Writing writing(Path other) {
    return new Writing(actions, other, text(), null);
  }

  private Writing.Text text() {
    return new Writing.Text(document.snapshot(), document.fault().isEmpty());
  }

  /** The writing is done; on the document's thread. */
  public void written(Writing done) {
    path = done.target();
    stamp = done.stamp();
    sound = done.text().sound();
    document.markSaved(done.text().snapshot());
  }

  /**
   * Writes the document to its file.
   *
   * @throws FileChanged if somebody else has written the file; {@link Writing#over} does it all the
   *     same
   * @throws IOException if it cannot be written, with one line that names it and says what to do
   */
  public void save() throws IOException {
    save(writing());
  }

  /** Writes the document to another file, which is its file from now on. */
  public void saveAs(Path other) throws IOException {
    save(writing(other));
  }

  private void save(Writing writing) throws IOException {
    writing.write();
    written(writing);
  }
}
