package org.selectiverenderer.cli.option;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.base.files.FileFinder;

/**
 * The input files of a command as the user named them.
 *
 * @param names of files, folders and patterns, at least one
 */
public record FileArguments(List<String> names) {
  /** Returns whether the user named exactly one file. */
  public boolean one() {
    return names.size() == 1 && !FileFinder.meansSeveral(names.get(0));
  }

  /** Returns the only file. */
  public Path file() {
    return Path.of(names.get(0));
  }

  /**
   * Returns all files, each once, in the order of the names.
   *
   * @throws IOException if a name matches no file
   */
  public List<Path> files(FileFinder finder) throws IOException {
    Set<Path> files = new LinkedHashSet<>();
    for (String name : names) {
      files.addAll(finder.find(name));
    }
    return List.copyOf(files);
  }
}
