package org.selectiverenderer.app.examples;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.files.FileTransaction;

/** A folder of the user's with copies of the examples, in which nothing is ever overwritten. */
public final class ExampleFolder {
  private final Path folder;

  /**
   * @param folder created with the first copy
   */
  public ExampleFolder(Path folder) {
    this.folder = folder;
  }

  /**
   * Returns the file of an example.
   *
   * @param name with slashes
   */
  public Path file(String name) {
    return folder.resolve(name);
  }

  /** Tells what has been done with each file of the examples. */
  public record Copies(List<Path> written, List<Path> changed) {
    /**
     * @param written files that were not there
     * @param changed files that were there with another content, and were left alone
     */
    public Copies {
      written = List.copyOf(written);
      changed = List.copyOf(changed);
    }
  }

  /**
   * Returns the files in the folder that have the name of an example and another content.
   *
   * @throws IOException if one of them cannot be read
   */
  public List<Path> changed(Map<String, byte[]> examples) throws IOException {
    List<Path> changed = new ArrayList<>();
    for (Map.Entry<String, byte[]> example : examples.entrySet()) {
      Path file = file(example.getKey());
      if (Files.exists(file) && !same(file, example.getValue())) {
        changed.add(file);
      }
    }
    return changed;
  }

  private static boolean same(Path file, byte[] content) throws IOException {
    return Files.isRegularFile(file)
        && Files.size(file) == content.length
        && Arrays.equals(Files.readAllBytes(file), content);
  }

  /**
   * Writes the examples that are not there: all of them, or none where one cannot be written. Those
   * that the user has changed stay as they are.
   *
   * @throws IOException with one sentence
   */
  public Copies complete(Map<String, byte[]> examples) throws IOException {
    List<Path> changed = changed(examples);
    List<Path> written = new ArrayList<>();
    FileTransaction copies = new FileTransaction();
    for (Map.Entry<String, byte[]> example : examples.entrySet()) {
      Path file = file(example.getKey());
      if (!Files.exists(file)) {
        requireInside(file);
        copies.addNew(file, example.getValue());
        written.add(file);
      }
    }
    copies.commit();
    return new Copies(written, changed);
  }

  /** Refuses a file whose folder is a link that leads elsewhere. */
  private void requireInside(Path file) throws IOException {
    if (!Files.isDirectory(folder)) {
      return;
    }
    Path above = file.toAbsolutePath().getParent();
    while (above != null && !Files.exists(above)) {
      above = above.getParent();
    }
    if (above == null || !above.toRealPath().startsWith(folder.toRealPath())) {
      throw new IOException(
          file + " is not written, since its folder is a link that leads out of " + folder);
    }
  }
}
