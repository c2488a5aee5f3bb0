package org.selectiverenderer.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * Looks at files to be written before the work begins, so that a slip in a name does not cost it.
 */
final class OutputFile {
  private OutputFile() {}

  /**
   * @param option by which the user named the file; null when there is none
   * @param ending that the name is to have, such as {@code .png}; empty for any
   */
  static void check(String option, @Nullable Path file, String ending) {
    if (file == null) {
      return;
    }
    Path folder = file.toAbsolutePath().getParent();
    if (folder == null || Files.isDirectory(file)) {
      throw CommandFailure.environment(option + " " + file + ": is a folder, not a file");
    }
    if (!Files.isDirectory(folder)) {
      throw CommandFailure.environment(
          option + " " + file + ": the folder " + folder + " does not exist");
    }
    if (!Files.isWritable(Files.exists(file) ? file : folder)) {
      throw CommandFailure.environment(option + " " + file + ": cannot be written");
    }
    if (!file.toString().toLowerCase(Locale.ROOT).endsWith(ending)) {
      throw CommandFailure.usage(option + " writes " + ending + " files; " + file + " is none");
    }
  }
}
