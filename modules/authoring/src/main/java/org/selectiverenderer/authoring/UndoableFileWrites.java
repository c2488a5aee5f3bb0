package org.selectiverenderer.authoring;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.FileNameLength;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.x3d.source.Gzip;

/**
 * The files that an undo step writes beside the document's own, with their contents before and
 * after the step: undoing removes or restores the files, redoing writes them again. A file that
 * another program has changed since is overwritten only on request, and then a backup is kept.
 *
 * <p>The contents are kept compressed in memory; {@link UndoHistory} limits their total size.
 */
public final class UndoableFileWrites {
  /** A file with its compressed contents before and after; empty where there is no file. */
  private record Both(Path file, Optional<byte[]> before, Optional<byte[]> after) {}

  private final List<Both> files;
  private final List<Path> folders;

  private UndoableFileWrites(List<Both> files, List<Path> folders) {
    this.files = List.copyOf(files);
    this.folders = List.copyOf(folders);
  }

  /**
   * Writes files, all or none, and keeps their contents; this may take long.
   *
   * @param check runs between the files and may throw to end the work before any is written
   * @throws IOException if one cannot be read or written, with a one-line message that names it;
   *     nothing has changed then
   */
  public static UndoableFileWrites write(List<UndoableFileWrite> wanted, Runnable check)
      throws IOException {
    List<Both> files = new ArrayList<>();
    List<Path> folders = new ArrayList<>();
    for (UndoableFileWrite file : wanted) {
      check.run();
      Path folder = file.file().toAbsolutePath().getParent();
      if (folder != null && !Files.exists(folder) && !folders.contains(folder)) {
        folders.add(folder);
      }
      Optional<byte[]> before = content(file.file());
      if (before.isPresent() && file.byHand()) {
        keepBeside(file.file(), before.get());
      }
      files.add(
          new Both(
              file.file(), before.map(Gzip::packed), Optional.of(Gzip.packed(file.content()))));
    }
    check.run();
    UndoableFileWrites step = new UndoableFileWrites(files, folders);
    step.write(false);
    return step;
  }

  /**
   * Undoes the writing where no step comes of it.
   *
   * @throws IOException if a file cannot be removed or restored, or another program has changed it
   */
  public void withdraw() throws IOException {
    move(true, false);
  }

  /** Returns the size of the compressed contents in bytes. */
  long size() {
    return files.stream()
        .mapToLong(file -> file.before().map(b -> b.length).orElse(0) + file.after().get().length)
        .sum();
  }

  /**
   * Returns the files that were changed by another program since the step, or its undoing.
   *
   * @param back whether the step is to be undone
   */
  List<Path> changedMeanwhile(boolean back) throws IOException {
    List<Path> changed = new ArrayList<>();
    for (Both file : files) {
      if (!matches(file.file(), back ? file.after() : file.before())) {
        changed.add(file.file());
      }
    }
    return changed;
  }

  private static boolean matches(Path file, Optional<byte[]> expected) throws IOException {
    Optional<byte[]> now = content(file);
    if (now.isEmpty() || expected.isEmpty()) {
      return now.isEmpty() == expected.isEmpty();
    }
    return Arrays.equals(now.get(), Gzip.unpacked(expected.get()));
  }

  private static Optional<byte[]> content(Path file) throws IOException {
    return Files.exists(file, LinkOption.NOFOLLOW_LINKS)
        ? Optional.of(Files.readAllBytes(file))
        : Optional.empty();
  }

  /**
   * Restores the contents of the files before or after the step.
   *
   * @param over whether files that another program has changed are replaced; backups are kept
   * @throws IOException if one cannot be written, with a one-line message that names it
   */
  void move(boolean back, boolean over) throws IOException {
    List<Path> changed = changedMeanwhile(back);
    if (!changed.isEmpty() && !over) {
      throw new IOException(
          changed.get(0)
              + ": another program has changed the file since; it is not overwritten, and nothing"
              + " is done");
    }
    for (Path file : changed) {
      Optional<byte[]> theirs = content(file);
      if (theirs.isPresent()) {
        keepBeside(file, theirs.get());
      }
    }
    write(back);
  }

  private void write(boolean back) throws IOException {
    FileTransaction writing = new FileTransaction();
    for (Both file : files) {
      Optional<byte[]> content = back ? file.before() : file.after();
      if (content.isPresent()) {
        writing.add(file.file(), Gzip.unpacked(content.get()));
      }
    }
    writing.commit();
    if (back) {
      removeNew();
    }
  }

  private void removeNew() throws IOException {
    for (Both file : files) {
      if (file.before().isEmpty()) {
        Files.deleteIfExists(file.file());
      }
    }
    for (Path folder : folders) {
      if (empty(folder)) {
        Files.delete(folder);
      }
    }
  }

  private static boolean empty(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return false;
    }
    try (var inside = Files.newDirectoryStream(folder)) {
      return !inside.iterator().hasNext();
    }
  }

  /**
   * Writes a backup under the first name with {@code .bak} that is free or has the same content.
   */
  private static void keepBeside(Path file, byte[] content) throws IOException {
    Path backup = backup(file, ".bak");
    for (int i = 2; Files.exists(backup, LinkOption.NOFOLLOW_LINKS); i++) {
      if (Files.isRegularFile(backup) && Arrays.equals(Files.readAllBytes(backup), content)) {
        return;
      }
      backup = backup(file, "." + i + ".bak");
    }
    AtomicFileWriter.replace(backup, content);
  }

  private static Path backup(Path file, String ending) {
    String name = FileNameLength.shortened(file.getFileName().toString(), ending.length());
    return file.resolveSibling(name + ending);
  }
}
