package org.selectiverenderer.browser.sai;

import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.FileUrl;

/** Converts between the addresses that SAI applications pass (file names or URLs) and files. */
final class SaiUrls {
  /** At least two letters, because one letter is a drive of Windows. */
  private static final Pattern SCHEME = Pattern.compile("^[A-Za-z][A-Za-z0-9+.-]+:.*");

  private SaiUrls() {}

  /** Returns whether an address is that of a file, not one of the network or another URL scheme. */
  static boolean isFile(String url) {
    return FileUrl.is(url) || !SCHEME.matcher(url).lookingAt();
  }

  /**
   * Returns the file at an address.
   *
   * @throws IOException with a one-line message if it is not the address of a file
   */
  static Path path(String url) throws IOException {
    try {
      if (FileUrl.is(url)) {
        return Path.of(FileUrl.uri(url));
      }
      if (!isFile(url)) {
        throw new IOException(url + " is not the address of a file");
      }
      return Path.of(url);
    } catch (IllegalArgumentException | FileSystemNotFoundException e) {
      throw new IOException(url + " is not the address of a file: " + e.getMessage(), e);
    }
  }

  /**
   * Returns the base that a scene's relative URLs are resolved against, given the scene's own
   * address or a folder.
   */
  static BaseUrl base(String baseUrl) throws IOException {
    if (isFile(baseUrl)) {
      return BaseUrl.folder(folder(baseUrl));
    }
    try {
      return new BaseUrl.Web(URI.create(baseUrl));
    } catch (IllegalArgumentException e) {
      throw new IOException(baseUrl + " is not a URL: " + e.getMessage(), e);
    }
  }

  private static Path folder(String baseUrl) throws IOException {
    Path path = path(baseUrl);
    if (baseUrl.isBlank() || Files.isDirectory(path)) {
      return path;
    }
    Path parent = path.getParent();
    return parent == null ? Path.of("") : parent;
  }

  /** Returns the full URL of a source that is a file; empty for any other source. */
  static String urlOf(String source) {
    try {
      Path file = path(source);
      return Files.isRegularFile(file) ? url(file) : "";
    } catch (IOException e) {
      return ""; // The name of a source serves messages and need not be a file name.
    }
  }

  /** Returns a file's full URL. */
  static String url(Path file) {
    return file.toAbsolutePath().normalize().toUri().toString();
  }
}
