package org.selectiverenderer.cli.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.x3d.files.FilesNamed;

/**
 * The files that a command reads and writes. Looked at before the work begins: none may be written
 * over one that is read, and no two over one another, whatever names lead to them.
 */
public final class CommandFiles {
  private record Named(String option, Path file) {
    @Override
    public String toString() {
      return (option + " " + file).strip();
    }
  }

  private final List<Named> read = new ArrayList<>();
  private final List<Named> written = new ArrayList<>();

  /**
   * @param option by which the user named the file; empty for a parameter
   * @param file null when there is none
   */
  public CommandFiles reads(String option, @Nullable Path file) {
    if (file != null) {
      read.add(new Named(option, file));
    }
    return this;
  }

  /**
   * @param option by which the user named the file
   * @param file null when there is none
   */
  public CommandFiles writes(String option, @Nullable Path file) {
    if (file != null && !FileTransaction.sink(file)) {
      written.add(new Named(option, file));
    }
    return this;
  }

  /** Refuses what would be written over something else. */
  public void check() throws IOException {
    for (int i = 0; i < written.size(); i++) {
      Named output = written.get(i);
      for (Named input : read) {
        if (same(output.file(), input.file())) {
          throw CommandFailure.usage(output + ": would overwrite " + input + ", which is read");
        }
      }
      for (Named other : written.subList(0, i)) {
        if (same(output.file(), other.file())) {
          throw CommandFailure.usage(output + ": is written by " + other + " too");
        }
      }
    }
  }

  /**
   * Refuses what would be written over a file that a scene is made of: what it inlines, shows or
   * plays. Asked when the scene has been read, before the work begins.
   *
   * @throws IOException with one line
   */
  public void check(FilesNamed named) throws IOException {
    for (Named output : written) {
      if (Files.exists(output.file())) {
        for (Path input : named.list()) {
          if (same(output.file(), input)) {
            throw new IOException(
                output + ": the scene is made of this file, which would be lost; name another");
          }
        }
      }
    }
  }

  private static boolean same(Path one, Path other) throws IOException {
    if (Files.exists(one) && Files.exists(other)) {
      return Files.isSameFile(one, other);
    }
    return place(one).equals(place(other));
  }

  private static Path place(Path file) throws IOException {
    Path whole = file.toAbsolutePath().normalize();
    Path folder = whole.getParent();
    return folder == null || !Files.isDirectory(folder)
        ? whole
        : folder.toRealPath().resolve(whole.getFileName());
  }
}
