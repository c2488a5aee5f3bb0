package org.selectiverenderer.polygon.versions;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Writes several files, all or none. Their contents go to temporary files beside them first; only
 * when all are on the disk do they take the names. What had a name before is kept until the end and
 * comes back if anything fails.
 */
public final class FileTransaction {
  /** Links that lead to one another, as many as Linux follows. */
  private static final int MOST_LINKS = 40;

  private interface Undo {
    void run() throws IOException;
  }

  private final FileActions actions;
  private final Map<Path, byte[]> files = new LinkedHashMap<>();
  private final Deque<Undo> undo = new ArrayDeque<>();

  public FileTransaction(FileActions actions) {
    this.actions = actions;
  }

  /**
   * Adds a file; a symbolic link stays one, and what it names is replaced. What is no file of a
   * disk, such as a pipe or a device, is written to and not replaced.
   */
  public void add(Path file, byte[] content) {
    files.put(file, content);
  }

  /**
   * Writes all files, and the folders that they need.
   *
   * @return files of the state before under other names, which could not be deleted; empty unless
   *     something is wrong with the disk
   * @throws IOException if one cannot be written, with one line that names it; nothing has changed
   *     then, unless it says so
   */
  public List<Path> commit() throws IOException {
    List<Path> kept = new ArrayList<>();
    Path at = null;
    try {
      Map<Path, Path> temporary = new LinkedHashMap<>();
      Map<Path, byte[]> sinks = new LinkedHashMap<>();
      for (Map.Entry<Path, byte[]> file : files.entrySet()) {
        at = file.getKey();
        if (sink(at)) {
          sinks.put(at, file.getValue());
        } else {
          Path target = target(at);
          temporary.put(target, stage(target, file.getValue()));
        }
      }
      for (Map.Entry<Path, Path> file : temporary.entrySet()) {
        at = file.getKey();
        exchange(file.getValue(), at, kept);
      }
      // What has gone through a pipe cannot be taken back, so it comes last.
      for (Map.Entry<Path, byte[]> sink : sinks.entrySet()) {
        at = sink.getKey();
        actions.pour(at, sink.getValue());
      }
    } catch (IOException | RuntimeException e) {
      throw new IOException(
          "%s cannot be written (%s); %s".formatted(at, reason(e), rollBack(e)), e);
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

  /** The file itself, or what the link is about even if that does not exist yet. */
  private static Path target(Path file) throws IOException {
    if (Files.exists(file)) {
      return file.toRealPath();
    }
    Path target = file.toAbsolutePath().normalize();
    for (int links = 0; Files.isSymbolicLink(target); links++) {
      if (links == MOST_LINKS) {
        throw new IOException("it is a link to itself");
      }
      target = target.resolveSibling(Files.readSymbolicLink(target)).normalize();
    }
    return target;
  }

  private Path stage(Path target, byte[] content) throws IOException {
    if (Files.isDirectory(target)) {
      throw new IOException("it is a folder");
    }
    Path folder = target.getParent();
    createFolders(folder);
    if (Files.exists(target) && !Files.isWritable(target)) {
      throw new IOException("it is write-protected");
    }
    Path temporary = beside(target, "new");
    undo.push(() -> actions.delete(temporary));
    actions.write(temporary, content);
    copyPermissions(target, temporary);
    return temporary;
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

  private static void copyPermissions(Path from, Path to) throws IOException {
    PosixFileAttributeView old = Files.getFileAttributeView(from, PosixFileAttributeView.class);
    PosixFileAttributeView made = Files.getFileAttributeView(to, PosixFileAttributeView.class);
    if (old != null && made != null && Files.exists(from)) {
      made.setPermissions(old.readAttributes().permissions());
    }
  }

  private void exchange(Path temporary, Path target, List<Path> kept) throws IOException {
    if (Files.exists(target)) {
      Path old = beside(target, "old");
      actions.move(target, old);
      undo.push(() -> actions.move(old, target));
      kept.add(old);
    } else {
      undo.push(() -> actions.delete(target));
    }
    actions.move(temporary, target);
  }

  /** A name that no file has. */
  private static Path beside(Path target, String kind) {
    for (int i = 0; ; i++) {
      Path name = target.resolveSibling("." + target.getFileName() + "." + kind + i);
      if (Files.notExists(name)) {
        return name;
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
    return complete ? "nothing has been changed" : "not all of what was done could be undone";
  }

  private static String reason(Exception e) {
    if (e instanceof AccessDeniedException) {
      return "permission denied";
    }
    if (e instanceof FileSystemException file && file.getReason() != null) {
      return file.getReason();
    }
    return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
  }
}
