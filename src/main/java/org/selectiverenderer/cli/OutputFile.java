package org.selectiverenderer.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.polygon.versions.FileTransaction;

/**
 * Looks at files to be written before the work begins, so that a slip in a name does not cost it.
 */
final class OutputFile {
  private OutputFile() {}

  /**
   * @param option by which the user named the file; null when there is none
   * @param endings of which the name is to have one, such as {@code .png}; none for any
   */
  static void check(String option, @Nullable Path file, String... endings) {
    if (file == null) {
      return;
    }
    if (FileTransaction.sink(file)) {
      return; // A pipe or a device has any name.
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
    String name = file.toString().toLowerCase(Locale.ROOT);
    if (endings.length > 0 && Arrays.stream(endings).noneMatch(name::endsWith)) {
      throw CommandFailure.usage(
          option + " writes " + String.join(" or ", endings) + " files; " + file + " is none");
    }
  }
}
