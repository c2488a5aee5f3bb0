package org.selectiverenderer.authoring.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.files.FileNameLength;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.InputFileReader;

/**
 * A document and its file. Saving first copies the previous file to a backup beside it (a file that
 * was not well-formed to a separate backup, so that the last good copy stays), replaces the file
 * atomically, and does not overwrite changes that another program has made since. After a failure,
 * document and file are unchanged.
 */
public final class DocumentFile {
  private final FileOperations actions;
  private final SceneDocument document;
  private Path path;
  private @Nullable FileFingerprint stamp;

  /** Whether the file's text, as opened or saved last, is well-formed. */
  private boolean sound;

  /** The last text that file and document had in common; null for none. */
  private @Nullable String common;

  private DocumentFile(
      FileOperations actions, SceneDocument document, Path path, @Nullable FileFingerprint stamp) {
    this.actions = actions;
    this.document = document;
    this.path = path;
    this.stamp = stamp;
    this.sound = document.fault().isEmpty();
    this.common = stamp == null ? null : document.snapshot().text();
  }

  /** Opens a file. */
  public static DocumentFile open(Path path) throws IOException {
    return open(path, FileOperations.REAL);
  }

  /**
   * Opens a file.
   *
   * @throws IOException if it cannot be read, with a one-line message that names it
   */
  public static DocumentFile open(Path path, FileOperations actions) throws IOException {
    if (Files.isDirectory(path)) {
      throw new IOException(path + ": this is a folder, not a scene");
    }
    byte[] bytes;
    FileFingerprint stamp;
    try {
      bytes = InputFileReader.bytes(path);
      stamp = FileFingerprint.of(path, bytes);
    } catch (NoSuchFileException e) {
      throw new IOException(path + ": the file does not exist", e);
    } catch (AccessDeniedException e) {
      throw new IOException(path + ": no permission to read the file", e);
    }
    return new DocumentFile(actions, SceneDocument.of(path.toString(), bytes), path, stamp);
  }

  /**
   * Creates a document that has no file yet, such as one that was recovered after its file was
   * deleted.
   */
  static DocumentFile unsaved(Path path, SceneDocument document) {
    document.markUnsaved();
    return new DocumentFile(FileOperations.REAL, document, path, null);
  }

  /**
   * Opens a text that was converted from another file.
   *
   * @param path the file into which it will be saved
   */
  public static DocumentFile made(Path path, String text) throws IOException {
    return unsaved(path, SceneDocument.of(path.toString(), text.getBytes(StandardCharsets.UTF_8)));
  }

  public SceneDocument document() {
    return document;
  }

  /** Returns the file from which it was opened or to which it was saved last. */
  public Path path() {
    return path;
  }

  /** Returns the backup of the last well-formed file before saving. */
  public Path backup() {
    return backup(path, true);
  }

  /**
   * Returns the backup of a file that was not well-formed, which never replaces {@link #backup()}.
   */
  public Path faultyBackup() {
    return backup(path, false);
  }

  static Path backup(Path file, boolean sound) {
    String ending = sound ? ".bak" : ".faulty.bak";
    String name = FileNameLength.shortened(file.getFileName().toString(), ending.length());
    return file.resolveSibling(name + ending);
  }

  private static FileState state(Path file, @Nullable FileFingerprint stamp) throws IOException {
    return stamp == null
        ? (Files.exists(file) ? FileState.CHANGED : FileState.GONE)
        : stamp.compare(file);
  }

  /** Returns the last text that file and document had in common; empty if there is none. */
  public Optional<String> common() {
    return Optional.ofNullable(common);
  }

  /**
   * Merges another program's changes of the file into the document as one undo step; the changed
   * file becomes the one that saving replaces.
   *
   * @throws org.selectiverenderer.authoring.EditRejectedException if the document is locked
   */
  public void take(ExternalFileVersion copy, Edit edit) {
    document.perform(edit);
    stamp = copy.stamp();
    sound = copy.sound();
    common = copy.text();
    if (document.text().toString().equals(copy.text())) {
      document.markSaved(document.snapshot());
    } else {
      document.markUnsaved();
    }
  }

  /** Detects changes of a file by other programs; may be called on any thread. */
  @FunctionalInterface
  public interface ChangeGuard {
    FileState state() throws IOException;
  }

  /** Returns a guard that detects changes of the file from now on. */
  public ChangeGuard guard() {
    Path file = path;
    FileFingerprint expected = stamp;
    return () -> state(file, expected);
  }

  /** Creates the operation that writes the present document to its file, on any thread. */
  public SaveOperation writing() {
    return new SaveOperation(actions, path, text(), new SaveOperation.Before(guard(), sound));
  }

  /**
   * Creates the operation that writes the present document to another file, which becomes the
   * document's file by {@link #written}.
   */
  public SaveOperation writing(Path other) {
    return new SaveOperation(actions, other, text(), null);
  }

  private SaveOperation.Text text() {
    return new SaveOperation.Text(document.snapshot(), document.fault().isEmpty());
  }

  /** Reports that an operation has been completed; to be called on the document's thread. */
  public void written(SaveOperation done) {
    path = done.target();
    stamp = done.stamp();
    sound = done.text().sound();
    common = done.text().snapshot().text();
    document.markSaved(done.text().snapshot());
  }

  /**
   * Writes the document to its file.
   *
   * @throws FileChangedException if another program has written the file; {@link
   *     SaveOperation#over} overwrites it
   * @throws IOException if it cannot be written, with a one-line message that names it and says
   *     what to do
   */
  public void save() throws IOException {
    save(writing());
  }

  /** Writes the document to another file, which becomes its file. */
  public void saveAs(Path other) throws IOException {
    save(writing(other));
  }

  private void save(SaveOperation writing) throws IOException {
    writing.write();
    written(writing);
  }
}
