package org.selectiverenderer.x3d;

import java.io.IOException;
import java.net.URI;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * Which files a scene may name: those in its own folder and below, and those in the folder {@value
 * #INLINE_FOLDER} beside its folder, where this project keeps the versions of objects. Never the
 * network.
 */
public final class ContentRoot {
  public static final String INLINE_FOLDER = "inlineNodes";

  /** Why a url is not opened, or the file that it names. */
  public sealed interface Target {
    record File(Path path) implements Target {}

    /**
     * @param reason a clause that reads after "url ... "
     */
    record Refused(String reason) implements Target {}
  }

  private final Path folder;
  private final Path inlineFolder;

  /**
   * @param sceneFolder the folder of the scene that the user named
   */
  public ContentRoot(Path sceneFolder) {
    folder = real(sceneFolder);
    Path above = folder.getParent();
    inlineFolder = real((above == null ? folder : above).resolve(INLINE_FOLDER));
  }

  /**
   * @param url as the file gives it, relative to {@code base} or absolute
   * @param base the folder of the file that names it
   */
  public Target resolve(String url, Path base) {
    String trimmed = url.strip();
    int fragment = trimmed.indexOf('#');
    String location = fragment < 0 ? trimmed : trimmed.substring(0, fragment);
    String lower = location.toLowerCase(Locale.ROOT);
    if (lower.matches("[a-z][a-z0-9+.-]+:.*") && !lower.startsWith("file:")) {
      return new Target.Refused(
          "is on the network or of a scheme that is not read: only files are");
    }
    Path path;
    try {
      path = lower.startsWith("file:") ? absolute(location) : relative(location, base);
    } catch (IllegalArgumentException | FileSystemNotFoundException e) {
      return new Target.Refused("is no file name");
    }
    Path real = real(path);
    if (!real.startsWith(folder) && !real.startsWith(inlineFolder)) {
      return new Target.Refused("points outside the scene's folder");
    }
    if (!Files.isRegularFile(real)) {
      return new Target.Refused("is missing" + similar(path));
    }
    return new Target.File(real);
  }

  private static Path absolute(String location) {
    return Path.of(URI.create(location));
  }

  private static Path relative(String location, Path base) {
    String decoded =
        location.indexOf('%') < 0
            ? location
            : URLDecoder.decode(location.replace("+", "%2B"), StandardCharsets.UTF_8);
    return base.resolve(decoded.replace('\\', '/'));
  }

  /** Follows links, so that none leads outside; a file that does not exist is only normalised. */
  private static Path real(Path path) {
    try {
      return path.toRealPath();
    } catch (IOException e) {
      Path absolute = path.toAbsolutePath().normalize();
      Path parent = absolute.getParent();
      if (parent == null || Files.notExists(parent)) {
        return absolute;
      }
      try {
        return parent.toRealPath().resolve(absolute.getFileName());
      } catch (IOException stillNot) {
        return absolute;
      }
    }
  }

  /** A hint for a name that differs in case only, which works on some systems and not on others. */
  private static String similar(Path path) {
    Path parent = path.getParent();
    Path name = path.getFileName();
    if (parent == null || name == null || !Files.isDirectory(parent)) {
      return "";
    }
    try (Stream<Path> files = Files.list(parent)) {
      return files
          .map(file -> String.valueOf(file.getFileName()))
          .filter(file -> file.equalsIgnoreCase(name.toString()))
          .findFirst()
          .map(file -> " (there is " + file + ": upper and lower case differ)")
          .orElse("");
    } catch (IOException e) {
      return "";
    }
  }
}
