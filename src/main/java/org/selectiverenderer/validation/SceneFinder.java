package org.selectiverenderer.validation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** Finds the scenes that a user means by a file or a folder. */
public final class SceneFinder {
  private final Path base;

  /**
   * @param base the folder that reports name files from
   */
  public SceneFinder(Path base) {
    this.base = base;
  }

  /**
   * A file itself, whatever its name; of a folder all {@code .x3d} and {@code .x3dz} files in it
   * and below.
   *
   * @throws IOException if a folder cannot be read
   */
  public List<SourceFile> find(Path path) throws IOException {
    if (!Files.isDirectory(path)) {
      return List.of(SourceFile.of(path, base));
    }
    List<SourceFile> found = new ArrayList<>();
    try (Stream<Path> files = Files.walk(path)) {
      files.filter(SceneFinder::isScene).forEach(file -> found.add(SourceFile.of(file, base)));
    }
    return found;
  }

  private static boolean isScene(Path path) {
    String name = String.valueOf(path.getFileName()).toLowerCase(Locale.ROOT);
    return (name.endsWith(".x3d") || name.endsWith(".x3dz")) && Files.isRegularFile(path);
  }
}
