package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Writes several files, all or none. Their contents go to temporary files beside them first; only
 * when all are on the disk do they take the names, each in one step and in the order in which they
 * were added. What had a name before is kept until the end and comes back if anything fails.
 */
public final class FileTransaction {
  static final String UNCHANGED = "nothing has been changed";

  private interface Undo {
    void run() throws IOException;
  }

  /** What is promised of a file. */
  private enum Promise {
    /** It comes in the place of what is there. */
    REPLACED,
    /** It never comes in the place of another content. */
    NEW,
    /** Besides, a power cut does not take its name. */
    LASTING
  }

  private record Content(byte[] bytes, Promise promise) {
    /** Whether it must not come in the place of another. */
    boolean once() {
      return promise != Promise.REPLACED;
    }
  }

  /** A file whose content is on the disk under another name. */
  private record Staged(Path file, Path target, Path temporary, Content content) {}

  private final FileActions actions;
  private final Map<Path, Content> files = new LinkedHashMap<>();
  private final Deque<Undo> undo = new ArrayDeque<>();
  private Path at = Path.of("");

  /** On the file system. */
  public FileTransaction() {
    this(FileActions.REAL);
  }

  /** A transaction in which nothing is written yet. */
  public FileTransaction(FileActions actions) {
    this.actions = actions;
  }

  /**
   * Adds a file; a symbolic link stays one, and what it names is replaced and keeps its
   * permissions. What is no file of a disk, such as a pipe or a device, is written to and not
   * replaced.
   */
  public void add(Path file, byte[] content) {
    files.put(file, new Content(content, Promise.REPLACED));
  }

  /**
   * Adds a file that is never replaced: one that is there with this content stays, one with another
   * makes all fail.
   */
  public void addNew(Path file, byte[] content) {
    files.put(file, new Content(content, Promise.NEW));
  }

  /**
   * As {@link #addNew}, and the disk has its name, too, when {@link #commit} returns; it fails
   * where that cannot be had.
   */
  public void addLasting(Path file, byte[] content) {
    files.put(file, new Content(content, Promise.LASTING));
  }

  /**
   * Writes all files, and the folders that they need.
   *
   * @return files of the state before under other names, which could not be deleted; empty unless
   *     something is wrong with the disk
   * @throws NotWritten if one cannot be written, with one line that names it; nothing has changed
   *     then, unless it says so
   */
  public List<Path> commit() throws IOException {
    List<Path> kept = new ArrayList<>();
    try {
      List<Staged> staged = new ArrayList<>();
      Map<Path, byte[]> sinks = new LinkedHashMap<>();
      for (Map.Entry<Path, Content> file : files.entrySet()) {
        at = file.getKey();
        if (sink(at)) {
          sinks.put(at, file.getValue().bytes());
        } else {
          stage(file.getValue(), staged);
        }
      }
      for (Staged file : staged) {
        at = file.file();
        exchange(file, staged.size() + sinks.size() > 1, kept);
      }
      for (Staged file : staged) {
        at = file.file();
        forceName(file);
      }
      // What has gone through a pipe cannot be taken back, so it comes last.
      for (Map.Entry<Path, byte[]> sink : sinks.entrySet()) {
        at = sink.getKey();
        actions.pour(at, sink.getValue());
      }
    } catch (IOException | RuntimeException e) {
      throw new NotWritten(at, e, rollBack(e));
    }
    undo.clear();
    return leftAfterDeleting(kept);
  }

  private List<Path> leftAfterDeleting(List<Path> kept) {
    List<Path> left = new ArrayList<>();
    for (Path old : kept) {
      try {
        actions.delete(old);
      } catch (IOException e) {
        left.add(old); // The caller tells; the new files are where they belong.
      }
    }
    return List.copyOf(left);
  }

  /** Whether something exists that is written to as it is: a pipe, a terminal, /dev/null. */
  public static boolean sink(Path file) {
    return Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file);
  }

  private void stage(Content content, List<Staged> staged) throws IOException {
    Path target = FileNames.target(at);
    if (Files.isDirectory(target)) {
      throw new IOException("it is a folder");
    }
    if (content.once() && Files.exists(target)) {
      if (!Arrays.equals(Files.readAllBytes(target), content.bytes())) {
        throw new IOException("it exists already with other content");
      }
      return;
    }
    createFolders(target.getParent());
    if (Files.exists(target) && !Files.isWritable(target)) {
      throw new IOException("it is write-protected");
    }
    Path temporary = FileNames.beside(target, "new");
    undo.push(() -> actions.delete(temporary));
    actions.write(temporary, content.bytes());
    FileNames.copyPermissions(target, temporary);
    staged.add(new Staged(at, target, temporary, content));
  }

  private void createFolders(Path folder) throws IOException {
    if (Files.isDirectory(folder)) {
      return;
    }
    Path above = folder.getParent();
    if (above != null) {
      createFolders(above);
    }
    actions.createFolder(folder);
    undo.push(() -> actions.delete(folder));
  }

  /**
   * @param more whether there are other files, after whose failure this one must come back
   */
  private void exchange(Staged file, boolean more, List<Path> kept) throws IOException {
    Path target = file.target();
    if (file.content().once()) {
      actions.place(file.temporary(), target);
      undo.push(() -> actions.delete(target));
      return;
    }
    if (!Files.exists(target)) {
      undo.push(() -> actions.delete(target));
    } else if (more) {
      Path old = FileNames.beside(target, "old");
      actions.keep(target, old);
      kept.add(old);
      undo.push(
          () -> {
            actions.move(old, target);
            actions.delete(old); // To move one link of a file onto another does nothing (POSIX).
          });
    }
    actions.move(file.temporary(), target);
  }

  /** Some network folders refuse it: a file is whole in any case, the old or the new. */
  private void forceName(Staged file) throws IOException {
    try {
      actions.forceFolder(file.target().getParent());
    } catch (IOException e) {
      if (file.content().promise() == Promise.LASTING) {
        throw e;
      }
    }
  }

  private String rollBack(Exception failure) {
    boolean complete = true;
    for (Undo step : undo) {
      try {
        step.run();
      } catch (IOException e) {
        failure.addSuppressed(e);
        complete = false;
      }
    }
    undo.clear();
    return complete ? UNCHANGED : "some of the changes could not be undone";
  }
}
