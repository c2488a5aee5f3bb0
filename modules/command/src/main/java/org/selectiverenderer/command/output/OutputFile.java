package org.selectiverenderer.command.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.files.FileWriteException;

/**
 * Writes output files, and checks before the work begins that they can be written, so that a typing
 * error in a name does not cost the results.
 */
public final class OutputFile {
  private OutputFile() {}

  /**
   * Writes a text, replacing an existing file.
   *
   * @throws IOException with the file's name
   */
  public static void write(Path file, String text) throws IOException {
    write(file, text, FileOperations.REAL);
  }

  /**
   * Writes a text about people, replacing an existing file; one that is made is readable by its
   * owner only.
   *
   * @throws IOException with the file's name
   */
  public static void writePrivate(Path file, String text) throws IOException {
    write(file, text, FileOperations.PRIVATE);
  }

  /** Writes a text by given file operations. */
  static void write(Path file, String text, FileOperations actions) throws IOException {
    try {
      AtomicFileWriter.write(file, text.getBytes(StandardCharsets.UTF_8), actions);
    } catch (FileWriteException e) {
      throw new IOException(file + ": " + e.reason(), e);
    }
  }

  /**
   * Writes a text into a file that a user fills in afterwards: existing other content is not
   * overwritten.
   *
   * @throws IOException if it exists with another text, or cannot be written
   */
  public static void writeOnce(String option, Path file, String text) throws IOException {
    if (Files.isRegularFile(file)
        && !Arrays.equals(Files.readAllBytes(file), text.getBytes(StandardCharsets.UTF_8))) {
      throw new IOException(
          option
              + " "
              + file
              + ": exists already with other content, perhaps answers; it is not "
              + "overwritten");
    }
    write(file, text);
  }

  /**
   * @param option the option that names the file
   * @param endings the allowed file name extensions, such as {@code .png}; none for any
   */
  public static void check(String option, @Nullable Path file, String... endings) {
    if (file == null) {
      return;
    }
    if (FileTransaction.sink(file)) {
      return; // A pipe or a device has any name.
    }
    Path folder = file.toAbsolutePath().getParent();
    if (folder == null || Files.isDirectory(file)) {
      throw CommandException.environment(option + " " + file + ": is a folder, not a file");
    }
    if (!Files.isDirectory(folder)) {
      throw CommandException.environment(
          option + " " + file + ": the folder " + folder + " does not exist");
    }
    if (!Files.isWritable(Files.exists(file) ? file : folder)) {
      throw CommandException.environment(option + " " + file + ": cannot be written");
    }
    String name = file.toString().toLowerCase(Locale.ROOT);
    if (endings.length > 0 && Arrays.stream(endings).noneMatch(name::endsWith)) {
      throw CommandException.usage(
          option + " writes " + String.join(" or ", endings) + " files; " + file + " is not one");
    }
  }
}
