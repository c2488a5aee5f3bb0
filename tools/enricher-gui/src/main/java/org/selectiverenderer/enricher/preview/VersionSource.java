package org.selectiverenderer.enricher.preview;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/** The source of a version's model: a file, or content in memory before it is written. */
public sealed interface VersionSource {
  /** A file on the disk. */
  record OfFile(Path file) implements VersionSource {
    @Override
    public Object state() throws IOException {
      return Files.getLastModifiedTime(file).toMillis() + "/" + Files.size(file);
    }

    @Override
    public String name() {
      return file.toString();
    }

    @Override
    public byte[] bytes() throws IOException {
      return Files.readAllBytes(file);
    }

    @Override
    public Path folder() {
      Path parent = file.toAbsolutePath().getParent();
      return parent == null ? file : parent;
    }
  }

  /**
   * Content that may be written later.
   *
   * @param content the bytes, which must not be changed; compared by value
   * @param folder where the file would be, for relative urls
   */
  record OfContent(String name, byte[] content, Path folder) implements VersionSource {
    @Override
    public Object state() {
      return content.length + "/" + Arrays.hashCode(content);
    }

    @Override
    public byte[] bytes() {
      return content;
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof OfContent that
          && name.equals(that.name)
          && folder.equals(that.folder)
          && Arrays.equals(content, that.content);
    }

    @Override
    public int hashCode() {
      return 31 * name.hashCode() + Arrays.hashCode(content);
    }
  }

  /** Identifies the state of the source, as a cache key. */
  Object state() throws IOException;

  /** The name for messages. */
  String name();

  byte[] bytes() throws IOException;

  /** The folder against which its urls are resolved. */
  Path folder();
}
