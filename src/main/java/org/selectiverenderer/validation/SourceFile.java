package org.selectiverenderer.validation;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentBase;

/**
 * A file to be checked.
 *
 * @param path of the file; of a scene from standard input a name in the folder that its urls start
 *     from
 * @param name as reports name it: relative, with forward slashes
 * @param inMemory what was read from standard input, the network or the data of a url; null for a
 *     file on disk
 */
public record SourceFile(Path path, String name, @Nullable Content inMemory) {
  /** A file on disk. */
  public static SourceFile of(Path path, Path base) {
    return new SourceFile(path, ReportedNames.relative(path, base), null);
  }

  /** A scene from standard input, as if it lay in a folder under that name. */
  public static SourceFile of(Path path, String name, byte[] content) {
    Path parent = path.getParent();
    ContentBase base = ContentBase.folder(parent == null ? Path.of("") : parent);
    return new SourceFile(path, name, new Content.OfBytes(path.toString(), name, base, content));
  }

  /** What a url of a scene means. */
  public static SourceFile of(Content content, Path base) {
    return content
        .file()
        .map(path -> of(path, base))
        .orElseGet(() -> new SourceFile(base, content.name(), content));
  }

  /**
   * Opens it.
   *
   * @throws IOException if it cannot be read
   */
  public InputStream open() throws IOException {
    return inMemory == null ? Files.newInputStream(path) : inMemory.open();
  }

  /**
   * Its length in bytes.
   *
   * @throws IOException if it cannot be read
   */
  public long size() throws IOException {
    return inMemory == null ? Files.size(path) : inMemory.size();
  }

  /** Where its urls start. */
  public ContentBase base() {
    return inMemory == null ? ContentBase.folder(folder()) : inMemory.base();
  }

  /** The folder that it lies in, or counts as being in. */
  public Path folder() {
    Path parent = path.getParent();
    return parent == null ? Path.of("") : parent;
  }

  /** The same for one file on disk, whatever links lead to it. */
  public String key() {
    if (inMemory != null) {
      return inMemory.key();
    }
    try {
      return path.toRealPath().toString();
    } catch (IOException e) {
      return path.toAbsolutePath().normalize().toString(); // Not there: to open it will say so.
    }
  }
}
