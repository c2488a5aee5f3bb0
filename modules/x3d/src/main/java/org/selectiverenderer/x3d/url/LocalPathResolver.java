package org.selectiverenderer.x3d.url;

import java.io.IOException;
import java.net.URI;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.selectiverenderer.x3d.url.UrlResolver.Cause;
import org.selectiverenderer.x3d.url.UrlResolver.Target;

/** Converts the urls of local files to paths; whether these may be read is checked later. */
final class LocalPathResolver {
  private static final Pattern ENCODED = Pattern.compile("(?s)(?:[^%]++|%[0-9a-fA-F]{2})*+");

  /** A path, or the reason why there is none. */
  sealed interface Meaning {
    record File(Path path) implements Meaning {}

    record None(Target.Refused why) implements Meaning {}
  }

  private LocalPathResolver() {}

  /**
   * Converts a url.
   *
   * @param location a url without fragment, of the scheme {@code file} or without scheme
   * @param absolute whether it has the scheme
   * @param base the folder of the file that contains it
   */
  static Meaning meaning(String location, boolean absolute, Path base) {
    try {
      if (share(location, absolute)) {
        return new Meaning.None(
            new Target.Refused(
                Cause.NETWORK, "is on the network, a share of another computer; it is not read"));
      }
      return new Meaning.File(absolute ? Path.of(FileUrl.uri(location)) : relative(location, base));
    } catch (IllegalArgumentException | FileSystemNotFoundException e) {
      return new Meaning.None(new Target.Refused(Cause.NO_FILE_NAME, "is not a file name"));
    }
  }

  /**
   * Returns whether a url refers to another computer. This is checked before any file system
   * access, which would contact it.
   *
   * @throws IllegalArgumentException if the url is malformed
   */
  private static boolean share(String location, boolean absolute) {
    if (absolute) {
      URI uri = FileUrl.uri(location);
      return uri.getAuthority() != null || uri.getPath() != null && NetworkShare.is(uri.getPath());
    }
    return NetworkShare.is(location) || NetworkShare.is(decoded(location));
  }

  /** Decodes percent-encoding; a url with an invalid code is returned unchanged. */
  private static String decoded(String location) {
    if (location.indexOf('%') < 0 || !ENCODED.matcher(location).matches()) {
      return location;
    }
    return URLDecoder.decode(location.replace("+", "%2B"), StandardCharsets.UTF_8);
  }

  /** Resolves a relative url; a file with the literal name precedes the percent-decoded one. */
  private static Path relative(String location, Path base) {
    Path literal = base.resolve(location.replace('\\', '/'));
    if (location.indexOf('%') < 0 || Files.exists(literal)) {
      return literal;
    }
    return base.resolve(decoded(location).replace('\\', '/'));
  }

  /** Resolves symbolic links; of a missing file, those of its existing parent folders. */
  static Path real(Path path) {
    Path absolute = path.toAbsolutePath().normalize();
    Path present = path;
    while (present != null) {
      try {
        Path real = present.toRealPath();
        return present == path ? real : real.resolve(present.relativize(absolute));
      } catch (IOException e) {
        present = present == path ? absolute.getParent() : present.getParent();
      }
    }
    return absolute;
  }
}
