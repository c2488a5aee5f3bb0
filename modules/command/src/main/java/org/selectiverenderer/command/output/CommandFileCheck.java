package org.selectiverenderer.command.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.x3d.url.ReferencedFiles;

/**
 * Checks before a command starts that no output file overwrites an input file or another output
 * file, by whatever path they are named.
 */
public final class CommandFileCheck {
  private record Named(String option, Path file) {
    @Override
    public String toString() {
      return (option + " " + file).strip();
    }
  }

  private final List<Named> read = new ArrayList<>();
  private final List<Named> written = new ArrayList<>();

  /**
   * @param option the option that names the file; empty for a parameter
   * @param file null when there is none
   */
  public CommandFileCheck reads(String option, @Nullable Path file) {
    if (file != null) {
      read.add(new Named(option, file));
    }
    return this;
  }

  /**
   * @param option the option that names the file
   * @param file null when there is none
   */
  public CommandFileCheck writes(String option, @Nullable Path file) {
    if (file != null && !FileTransaction.sink(file)) {
      written.add(new Named(option, file));
    }
    return this;
  }

  /** Rejects an output file that would overwrite another file of the command. */
  public void check() throws IOException {
    for (int i = 0; i < written.size(); i++) {
      Named output = written.get(i);
      for (Named input : read) {
        if (same(output.file(), input.file())) {
          throw CommandException.usage(output + ": would overwrite " + input + ", which is read");
        }
      }
      for (Named other : written.subList(0, i)) {
        if (same(output.file(), other.file())) {
          throw CommandException.usage(output + ": is written by " + other + " too");
        }
      }
    }
  }

  /**
   * Rejects an output file that would overwrite a file of the scene, such as an Inline, picture or
   * sound. It is called when the scene has been read, before the work begins.
   *
   * @throws IOException with one line
   */
  public void check(ReferencedFiles named) throws IOException {
    for (Named output : written) {
      if (Files.exists(output.file())) {
        for (Path input : named.list()) {
          if (same(output.file(), input)) {
            throw new IOException(
                output + ": is a file of the scene and would be overwritten; name another one");
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
