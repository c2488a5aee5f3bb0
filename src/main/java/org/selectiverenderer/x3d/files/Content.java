package org.selectiverenderer.x3d.files;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * What a url means and may be read: a file, something fetched from the network, or the data in the
 * url itself. {@link ContentRoot} gives it; who reads it need not know which it is.
 */
public sealed interface Content {
  /** Equal for the same content, however it is named: what is read once is known by it. */
  String key();

  /** As messages name it. */
  String name();

  /** Where the relative urls in it start. */
  ContentBase base();

  /** Bytes, about; 0 where that is not known. */
  long size();

  /**
   * Opens it; the caller closes it.
   *
   * @throws IOException when it cannot be read
   */
  InputStream open() throws IOException;

  /** The file, where it is one of this machine. */
  default Optional<Path> file() {
    return Optional.empty();
  }

  /**
   * Reads all of it.
   *
   * @param most bytes
   * @throws IOException when it cannot be read or is larger, with a clause that reads after its
   *     name
   */
  default byte[] bytes(int most) throws IOException {
    try (InputStream in = open()) {
      byte[] bytes = in.readNBytes(most);
      if (bytes.length == most && in.read() >= 0) {
        throw new IOException("has more than %s bytes, which is the limit".formatted(most));
      }
      return bytes;
    }
  }

  /**
   * A file of this machine.
   *
   * @param path the real path
   */
  record OfFile(Path path, String name) implements Content {
    @Override
    public String key() {
      return path.toString();
    }

    @Override
    public ContentBase base() {
      Path folder = path.getParent();
      return new ContentBase.Folder(folder == null ? path : folder);
    }

    @Override
    public long size() {
      return path.toFile().length();
    }

    @Override
    public InputStream open() throws IOException {
      return Files.newInputStream(path);
    }

    @Override
    public Optional<Path> file() {
      return Optional.of(path);
    }
  }

  /** Bytes in memory: of a {@code data:} url, or fetched. Nobody changes them. */
  record OfBytes(String key, String name, ContentBase base, byte[] data) implements Content {
    @Override
    public long size() {
      return data.length;
    }

    @Override
    public InputStream open() {
      return new ByteArrayInputStream(data);
    }
  }
}
