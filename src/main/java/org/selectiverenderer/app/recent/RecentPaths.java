package org.selectiverenderer.app.recent;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.InputFileReader;

/** Files that were opened lately, the latest first, in a file of the user's settings. */
public final class RecentPaths {
  /** Most files that are kept. */
  static final int MOST = 10;

  private final Path file;

  private RecentPaths(Path file) {
    this.file = file;
  }

  /**
   * Returns the list of the study window.
   *
   * @param settings folder of the user's settings; created with the first file
   */
  public static RecentPaths studies(Path settings) {
    return new RecentPaths(settings.resolve("studies"));
  }

  /**
   * Returns the list of the scenes that the start window has shown.
   *
   * @param settings folder of the user's settings; created with the first file
   */
  public static RecentPaths scenes(Path settings) {
    return new RecentPaths(settings.resolve("scenes"));
  }

  /**
   * Returns the list of the folders into which the examples were copied.
   *
   * @param settings folder of the user's settings; created with the first folder
   */
  public static RecentPaths exampleFolders(Path settings) {
    return new RecentPaths(settings.resolve("example-folders"));
  }

  /** Returns the files; none where the list cannot be read, which is no harm. */
  public List<Path> list() {
    List<Path> paths = new ArrayList<>();
    if (!Files.isRegularFile(file)) {
      return paths;
    }
    try {
      for (String line : InputFileReader.text(file).lines().toList()) {
        if (!line.isBlank() && paths.size() < MOST) {
          paths.add(Path.of(line));
        }
      }
    } catch (IOException | InvalidPathException e) {
      return paths;
    }
    return paths;
  }

  /**
   * Puts a file first.
   *
   * @throws IOException if the list cannot be written
   */
  public void add(Path opened) throws IOException {
    Path absolute = opened.toAbsolutePath().normalize();
    List<Path> paths = list();
    paths.remove(absolute);
    paths.add(0, absolute);
    write(paths);
  }

  /**
   * Removes a file from the list; the file itself stays.
   *
   * @throws IOException if the list cannot be written
   */
  public void remove(Path listed) throws IOException {
    List<Path> paths = list();
    if (paths.remove(listed.toAbsolutePath().normalize())) {
      write(paths);
    }
  }

  private void write(List<Path> paths) throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    StringBuilder text = new StringBuilder();
    paths.stream()
        .map(Path::toString)
        .filter(name -> name.lines().count() == 1)
        .limit(MOST)
        .forEach(name -> text.append(name).append('\n'));
    AtomicFileWriter.replace(file, text.toString().getBytes(StandardCharsets.UTF_8));
  }
}
