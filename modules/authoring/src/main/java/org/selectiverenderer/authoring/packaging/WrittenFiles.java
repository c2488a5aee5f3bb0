package org.selectiverenderer.authoring.packaging;

import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The files and folders that a package has written. What they replaced lies in a hidden folder
 * beside them, under the same names, until they are kept or withdrawn; one of the two must be
 * called in the end. Not thread-safe, and free of any thread.
 */
public final class WrittenFiles {
  /** Tells a file from another that takes its place. */
  private record Stamp(long size, FileTime modified) {
    static Stamp of(Path file) throws IOException {
      BasicFileAttributes is =
          Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
      return new Stamp(is.size(), is.lastModifiedTime());
    }
  }

  /** A place, where its former content is, and what has been put there; empty for nothing yet. */
  private record Exchange(Path place, Optional<Path> former, Optional<Stamp> put) {}

  private final List<Path> folders = new ArrayList<>();
  private final List<Exchange> exchanges = new ArrayList<>();
  private Optional<Path> stage = Optional.empty();

  WrittenFiles() {}

  /** Creates the hidden folder for what is not at its place yet, or no more. */
  Path stage(Path folder) throws IOException {
    Path made = Files.createDirectory(PackageWriter.part(folder.resolve("files")));
    stage = Optional.of(made);
    return made;
  }

  /** Returns where a file goes that is replaced, so that its owner finds it there by its name. */
  static Path former(Path stage, Path name) {
    return stage.resolve("replaced").resolve(name);
  }

  void createFolder(Path created) throws IOException {
    Files.createDirectory(created);
    folders.add(created);
  }

  /**
   * Moves a file to its place.
   *
   * @param former where the file goes that is there; empty if there is none
   */
  void exchange(Path content, Path place, Optional<Path> former) throws IOException {
    if (former.isPresent()) {
      Files.createDirectories(former.get().getParent());
      Files.move(place, former.get());
      exchanges.add(new Exchange(place, former, Optional.empty()));
    }
    Stamp put = Stamp.of(content);
    try {
      Files.move(content, place);
    } catch (FileAlreadyExistsException e) {
      throw new IOException(place + ": has appeared meanwhile, and is not replaced", e);
    }
    if (former.isPresent()) {
      exchanges.remove(exchanges.size() - 1);
    }
    exchanges.add(new Exchange(place, former, Optional.of(put)));
  }

  /** Returns itself when all is at its place; where nothing is replaced, nothing is hidden. */
  WrittenFiles complete() throws IOException {
    if (exchanges.stream().allMatch(exchange -> exchange.former().isEmpty())) {
      removeStage();
    }
    return this;
  }

  /**
   * Gives up what was replaced; nothing can be withdrawn any more.
   *
   * @throws IOException if it cannot be removed; with a sentence that names the folder where it is
   */
  public void keep() throws IOException {
    exchanges.clear();
    folders.clear();
    removeStage();
  }

  /**
   * Removes what was written and puts back what was replaced. A file that another program has
   * written since stays, and folders that others have put something into.
   *
   * @throws IOException if something cannot be removed or put back; all else is, and the sentence
   *     names the file, and where its former content is
   */
  public void withdraw() throws IOException {
    List<String> failed = new ArrayList<>();
    IOException cause = null;
    for (int i = exchanges.size() - 1; i >= 0; i--) {
      Exchange exchange = exchanges.get(i);
      try {
        undo(exchange);
      } catch (IOException e) {
        failed.add(sentence(exchange, e));
        if (cause == null) {
          cause = e;
        } else {
          cause.addSuppressed(e);
        }
      }
    }
    exchanges.clear();
    if (cause == null) {
      removeStage();
    }
    removeFolders();
    if (cause != null) {
      String more = failed.size() == 1 ? "" : " (and %d more)".formatted(failed.size() - 1);
      throw new IOException(failed.get(0) + more, cause);
    }
  }

  /**
   * Withdraws after a failure, which stays the one that is thrown.
   *
   * @throws IOException if something cannot be put back; its sentence begins with the failure's
   */
  void withdrawBecause(Throwable failure) throws IOException {
    try {
      withdraw();
    } catch (IOException e) {
      String first = failure.getMessage() == null ? "" : failure.getMessage() + "; ";
      e.addSuppressed(failure);
      throw new IOException(first + e.getMessage(), e);
    }
  }

  private static void undo(Exchange exchange) throws IOException {
    Path place = exchange.place();
    if (exchange.put().isPresent()
        && Files.exists(place, LinkOption.NOFOLLOW_LINKS)
        && exchange.put().get().equals(Stamp.of(place))) {
      Files.delete(place);
    }
    if (exchange.former().isPresent()) {
      Files.move(exchange.former().get(), place);
    }
  }

  private static String sentence(Exchange exchange, IOException why) {
    String reason =
        why instanceof FileAlreadyExistsException
            ? "another program has written it meanwhile"
            : String.valueOf(why.getMessage());
    return exchange
        .former()
        .map(
            former ->
                "%s: what was there is not put back (%s); it is kept as %s"
                    .formatted(exchange.place(), reason, former))
        .orElseGet(() -> "%s: is not removed (%s)".formatted(exchange.place(), reason));
  }

  private void removeFolders() throws IOException {
    for (int i = folders.size() - 1; i >= 0; i--) {
      try {
        Files.deleteIfExists(folders.get(i));
      } catch (DirectoryNotEmptyException e) {
        continue; // another program's files are in it
      }
    }
    folders.clear();
  }

  private void removeStage() throws IOException {
    if (stage.isEmpty()) {
      return;
    }
    Path folder = stage.get();
    stage = Optional.empty();
    try {
      List<Path> inside;
      try (var all = Files.walk(folder)) {
        inside = all.sorted(Comparator.reverseOrder()).toList();
      }
      for (Path file : inside) {
        Files.deleteIfExists(file);
      }
    } catch (IOException e) {
      throw new IOException(
          folder + ": cannot be removed and is needed no more (" + e.getMessage() + ")", e);
    }
  }
}
