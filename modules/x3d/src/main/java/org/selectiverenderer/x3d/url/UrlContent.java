package org.selectiverenderer.x3d.url;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The readable content of a url: a local file, a file fetched from the network, or the data in a
 * data: url. Resolved by {@link UrlResolver}; readers need not distinguish the three.
 */
public sealed interface UrlContent {
  /**
   * Returns the content that a url itself holds ({@code data:}, RFC 2397); empty for any other url.
   *
   * @param url the url without fragment
   * @param base the base of relative urls in the content
   * @throws IOException if the url is damaged or too large, with a predicate that follows the url
   */
  static Optional<UrlContent> inside(String url, BaseUrl base) throws IOException {
    return DataUrl.is(url) ? Optional.of(DataUrl.read(url, base)) : Optional.empty();
  }

  /** Returns a cache key, which is equal for the same content. */
  String key();

  /** Returns the name for messages. */
  String name();

  /** Returns the base of the relative urls in the content. */
  BaseUrl base();

  /** Returns the approximate size in bytes; 0 if unknown. */
  long size();

  /**
   * Opens the content; the caller closes the stream.
   *
   * @throws IOException if it cannot be read
   */
  InputStream open() throws IOException;

  /** Returns the path of a local file; else empty. */
  default Optional<Path> file() {
    return Optional.empty();
  }

  /**
   * Reads all bytes.
   *
   * @param most the maximum number of bytes
   * @throws IOException if it cannot be read or is larger; the message is a predicate that follows
   *     the content's name
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
   * A local file.
   *
   * @param path the real path
   */
  record OfFile(Path path, String name) implements UrlContent {
    @Override
    public String key() {
      return path.toString();
    }

    @Override
    public BaseUrl base() {
      Path folder = path.getParent();
      return new BaseUrl.Folder(folder == null ? path : folder);
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

  /** Bytes in memory, of a {@code data:} url or fetched; they must not be modified. */
  record OfBytes(String key, String name, BaseUrl base, byte[] data) implements UrlContent {
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
