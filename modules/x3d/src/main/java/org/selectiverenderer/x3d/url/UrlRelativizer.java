package org.selectiverenderer.x3d.url;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Objects;

/** Makes urls relative to another folder. */
public final class UrlRelativizer {
  private UrlRelativizer() {}

  /**
   * Returns the url that, relative to {@code to}, refers to the file that the given one refers to
   * relative to {@code from}.
   */
  public static String turned(String url, Path from, Path to) {
    String address = url.strip();
    boolean absolute =
        address.isEmpty()
            || address.startsWith("/")
            || address.startsWith("#")
            || address.matches("[A-Za-z][A-Za-z0-9+.-]+:(?s:.*)");
    if (absolute || from.toAbsolutePath().normalize().equals(to.toAbsolutePath().normalize())) {
      return url;
    }
    int fragment = address.indexOf('#');
    String path = fragment < 0 ? address : address.substring(0, fragment);
    String rest = fragment < 0 ? "" : address.substring(fragment);
    try {
      return relative(to, from.resolve(path.replace('\\', '/'))) + rest;
    } catch (InvalidPathException e) {
      return url;
    }
  }

  /**
   * Returns the relative url of a file as seen from a folder, with forward slashes on every system.
   * The characters {@code %}, {@code #} and {@code ?} are percent-encoded (RFC 3986, 2.1); spaces
   * stay, since browsers accept them.
   */
  public static String between(Path folder, Path file) {
    return relative(folder, file).replace("%", "%25").replace("#", "%23").replace("?", "%3F");
  }

  private static String relative(Path folder, Path file) {
    Path start = folder.toAbsolutePath().normalize();
    Path end = file.toAbsolutePath().normalize();
    Path relative = Objects.equals(start.getRoot(), end.getRoot()) ? start.relativize(end) : end;
    return relative.toString().replace('\\', '/');
  }
}
