package org.selectiverenderer.validation;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/**
 * A file to be checked.
 *
 * @param path of the file; of a scene from standard input a name in the folder that its urls start
 *     from
 * @param name as reports name it: relative, with forward slashes
 * @param content what was read from standard input; null for a file on disk
 */
public record SourceFile(Path path, String name, byte @Nullable [] content) {
  /** A file on disk. */
  public static SourceFile of(Path path, Path base) {
    return new SourceFile(path, ReportedNames.relative(path, base), null);
  }

  public InputStream open() throws IOException {
    return content == null ? Files.newInputStream(path) : new ByteArrayInputStream(content);
  }

  public long size() throws IOException {
    return content == null ? Files.size(path) : content.length;
  }

  /** The folder that its urls start from. */
  public Path folder() {
    Path parent = path.getParent();
    return parent == null ? Path.of("") : parent;
  }

  /** One object per file on disk, whatever links lead to it. */
  public Path key() {
    try {
      return content == null ? path.toRealPath() : path;
    } catch (IOException e) {
      return path.toAbsolutePath().normalize(); // Not there: to open it will say so.
    }
  }
}
