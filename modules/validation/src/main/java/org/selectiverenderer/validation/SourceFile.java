package org.selectiverenderer.validation;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * A file to check.
 *
 * @param path path of the file; for a scene from standard input, a made-up name in the folder
 *     against which its urls are resolved
 * @param name name in reports: a relative path with forward slashes
 * @param inMemory content read from standard input, the network or a data url; null for a file on
 *     disk
 */
public record SourceFile(Path path, String name, @Nullable UrlContent inMemory) {
  /** Returns a file on disk. */
  public static SourceFile of(Path path, Path base) {
    return new SourceFile(path, ReportFileNames.relative(path, base), null);
  }

  /** Returns a scene from standard input, as if it were a file of that path. */
  public static SourceFile of(Path path, String name, byte[] content) {
    Path parent = path.getParent();
    BaseUrl base = BaseUrl.folder(parent == null ? Path.of("") : parent);
    return new SourceFile(path, name, new UrlContent.OfBytes(path.toString(), name, base, content));
  }

  /** Returns the file that a url of a scene refers to. */
  public static SourceFile of(UrlContent content, Path base) {
    return content
        .file()
        .map(path -> of(path, base))
        .orElseGet(() -> new SourceFile(base, content.name(), content));
  }

  /**
   * Opens the file.
   *
   * @throws IOException if it cannot be read
   */
  public InputStream open() throws IOException {
    return inMemory == null ? Files.newInputStream(path) : inMemory.open();
  }

  /**
   * Returns the length in bytes.
   *
   * @throws IOException if it cannot be read
   */
  public long size() throws IOException {
    return inMemory == null ? Files.size(path) : inMemory.size();
  }

  /** Returns the base against which relative urls are resolved. */
  public BaseUrl base() {
    return inMemory == null ? BaseUrl.folder(folder()) : inMemory.base();
  }

  /** Returns the folder of the file. */
  public Path folder() {
    Path parent = path.getParent();
    return parent == null ? Path.of("") : parent;
  }

  /** Returns a key that is equal for all paths and links to the same file on disk. */
  public String key() {
    return inMemory == null ? key(path) : inMemory.key();
  }

  static String key(Path path) {
    try {
      return path.toRealPath().toString();
    } catch (IOException e) {
      return path.toAbsolutePath().normalize().toString(); // missing: opening it reports that
    }
  }
}
