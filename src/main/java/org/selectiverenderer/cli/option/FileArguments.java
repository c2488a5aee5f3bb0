package org.selectiverenderer.cli.option;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.base.files.FileFinder;

/**
 * The files that a command is about, as the user named them: one, or many.
 *
 * @param names of files, folders and patterns, at least one
 */
public record FileArguments(List<String> names) {
  /** Whether it is one file, named by itself. */
  public boolean one() {
    return names.size() == 1 && !FileFinder.meansSeveral(names.get(0));
  }

  /** The only file. */
  public Path file() {
    return Path.of(names.get(0));
  }

  /**
   * All files, each once, in the order of the names.
   *
   * @throws IOException if a name stands for no file
   */
  public List<Path> files(FileFinder finder) throws IOException {
    Set<Path> files = new LinkedHashSet<>();
    for (String name : names) {
      files.addAll(finder.find(name));
    }
    return List.copyOf(files);
  }
}
