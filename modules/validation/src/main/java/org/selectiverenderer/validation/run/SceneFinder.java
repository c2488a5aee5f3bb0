package org.selectiverenderer.validation.run;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.base.files.FileFinder;
import org.selectiverenderer.validation.SourceFile;

/** Finds the scenes that a user means by the name of a file or folder, a pattern, or {@code -}. */
public final class SceneFinder {
  /** The name that stands for standard input. */
  public static final String STANDARD_INPUT = "-";

  private final Path base;
  private final InputStream input;

  /**
   * @param base the folder that names in reports are relative to
   * @param input standard input
   */
  public SceneFinder(Path base, InputStream input) {
    this.base = base;
    this.input = input;
  }

  /**
   * Returns the files that {@link FileFinder#find} finds, or the scene on standard input.
   *
   * @throws IOException if there is no such file, or a folder cannot be read, or nothing is found
   */
  public List<SourceFile> find(String name) throws IOException {
    if (name.equals(STANDARD_INPUT)) {
      byte[] content = input.readAllBytes();
      return List.of(SourceFile.of(base.resolve("standard input"), "-", content));
    }
    return FileFinder.SCENES.find(name).stream().map(file -> SourceFile.of(file, base)).toList();
  }
}
