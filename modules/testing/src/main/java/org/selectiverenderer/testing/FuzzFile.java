package org.selectiverenderer.testing;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A file with the input of a fuzz target, for readers that take nothing but files. */
public final class FuzzFile {
  private FuzzFile() {}

  /** What reads the file; an {@code IOException} refuses it, which is an answer like any other. */
  @FunctionalInterface
  public interface Reader {
    /** Reads the file. */
    void read(Path file) throws IOException;
  }

  /** Writes a file of a given name into a folder of its own, reads and deletes it. */
  public static void with(String name, byte[] input, Reader reader) {
    try {
      Path folder = Files.createTempDirectory("fuzz");
      Path file = folder.resolve(name);
      try {
        Files.write(file, input);
        refused(reader, file);
      } finally {
        Files.deleteIfExists(file);
        Files.delete(folder);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void refused(Reader reader, Path file) {
    try {
      reader.read(file);
    } catch (IOException e) {
      // The reader's answer.
    }
  }
}
