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
 * Writes several files, all or none. Their contents are first written to temporary files beside
 * them; when all are on the disk, each is renamed atomically, in the order in which they were
 * added. The replaced files are kept until the end and restored if anything fails.
 */
public final class FileTransaction {
  static final String UNCHANGED = "nothing has been changed";

  private interface Undo {
    void run() throws IOException;
  }

  /** The guarantee given for a file. */
  private enum Promise {
    /** The file replaces an existing one. */
    REPLACED,
    /** The file never replaces one with other content. */
    NEW,
    /** As {@link #NEW}, and its name survives a power cut. */
    LASTING
  }

  private record Content(byte[] bytes, Promise promise) {
    /** Returns whether the file must not replace another. */
    boolean once() {
      return promise != Promise.REPLACED;
    }
  }

  /** A file whose content is on the disk under a temporary name. */
  private record Staged(Path file, Path target, Path temporary, Content content) {}

  private final FileOperations actions;
  private final Map<Path, Content> files = new LinkedHashMap<>();
  private final Deque<Undo> undo = new ArrayDeque<>();
  private Path at = Path.of("");

  /** Creates an empty transaction on the real file system. */
  public FileTransaction() {
    this(FileOperations.REAL);
  }

  /** Creates an empty transaction on these file operations. */
  public FileTransaction(FileOperations actions) {
    this.actions = actions;
  }

  /**
   * Adds a file. A symbolic link is kept and its target replaced, with the same permissions. A pipe
   * or device is written to, not replaced.
   */
  public void add(Path file, byte[] content) {
    files.put(file, new Content(content, Promise.REPLACED));
  }

  /**
   * Adds a file that must not replace another: an existing file with the same content stays, one
   * with other content makes the transaction fail.
   */
  public void addNew(Path file, byte[] content) {
    files.put(file, new Content(content, Promise.NEW));
  }

  /**
   * Adds a file as {@link #addNew} does, and forces its directory entry to the disk before {@link
   * #commit} returns; the commit fails if the file system cannot do that.
   */
  public void addLasting(Path file, byte[] content) {
    files.put(file, new Content(content, Promise.LASTING));
  }

  /**
   * Writes all files, and creates the folders that they need.
   *
   * @return backups of replaced files that could not be deleted; normally empty
   * @throws FileWriteException if a file cannot be written, with a one-line message that names it
   *     and says whether all changes have been undone
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
      // a write to a pipe cannot be undone, so it comes last
      for (Map.Entry<Path, byte[]> sink : sinks.entrySet()) {
        at = sink.getKey();
        actions.pour(at, sink.getValue());
      }
    } catch (IOException | RuntimeException e) {
      throw new FileWriteException(at, e, rollBack(e));
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
        left.add(old); // the caller reports it; the new files are complete
      }
    }
    return List.copyOf(left);
  }

  /** Returns whether a path is a pipe, terminal or device, which is written to in place. */
  public static boolean sink(Path file) {
    if (WindowsDeviceName.leadsToDevice(file)) {
      return !WindowsDeviceName.hasEnding(file);
    }
    return Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file);
  }

  private void stage(Content content, List<Staged> staged) throws IOException {
    if (WindowsDeviceName.leadsToDevice(at)) {
      throw new IOException("Windows takes this name for a device; choose another name");
    }
    Path target = actions.target(at);
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
    Path temporary = TargetPaths.beside(target, "new");
    undo.push(() -> actions.delete(temporary));
    actions.write(temporary, content.bytes());
    TargetPaths.copyPermissions(target, temporary);
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
   * @param more whether there are other files, whose failure would require this one to be restored
   */
  private void exchange(Staged file, boolean more, List<Path> kept) throws IOException {
    Path target = file.target();
    if (file.content().once()) {
      actions.place(file.temporary(), target);
      undo.push(() -> actions.delete(target));
      return;
    }
    if (!Files.exists(target)) {
      undo.push(
          () -> {
            if (Files.exists(target)) { // not so where its name is too long
              actions.delete(target);
            }
          });
    } else if (more) {
      Path old = TargetPaths.beside(target, "old");
      actions.keep(target, old);
      kept.add(old);
      undo.push(
          () -> {
            actions.move(old, target);
            actions.delete(old); // POSIX rename between two links of the same file does nothing
          });
    }
    actions.move(file.temporary(), target);
  }

  /** Syncs the directory entry; some network folders refuse, but the file is complete anyway. */
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
