package org.selectiverenderer.base.files;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Finds the files that a user names by a file, a folder or a glob pattern.
 *
 * @param noun the kind of file, for messages
 * @param endings file name endings to look for in folders, in lower case, such as {@code .x3d}
 */
public record FileFinder(String noun, List<String> endings) {
  private static final Pattern PATTERN_LETTERS = Pattern.compile("[*?\\[{]");

  /**
   * Finds X3D scenes in XML, ClassicVRML and JSON, and VRML97, gzipped or not. A {@code .json} file
   * is a scene only if the user names it, as most of them are something else.
   */
  public static final FileFinder SCENES =
      new FileFinder(
          "scene",
          List.of(
              ".x3d", ".x3dz", ".x3dv", ".x3dvz", ".wrl", ".wrz", ".wrl.gz", ".x3dj", ".x3djz"));

  /** Returns whether a name may stand for several files: a folder or a pattern. */
  public static boolean meansSeveral(String name) {
    Path path = path(name);
    return path == null || Files.isDirectory(path) || !Files.exists(path) && isPattern(name);
  }

  /**
   * Returns a named file itself, whatever its ending; all files with the endings in a folder and
   * below it, except where a file or folder name begins with a dot; or all files that match a
   * pattern such as {@code scenes/**}{@code /*.x3d}, in which {@code **}{@code /} stands for zero
   * or more folders. Devices and pipes are left out, and links to folders are not followed. The
   * files of a folder or pattern are sorted by path.
   *
   * @throws IOException if there is no such file, or a folder cannot be read, or nothing is found,
   *     or a link in a folder leads out of it
   */
  public List<Path> find(String name) throws IOException {
    Path path = path(name);
    List<Path> found;
    if (path != null && Files.isDirectory(path)) {
      found = in(path, this::wanted);
    } else if (path != null && (Files.exists(path) || !isPattern(name))) {
      return List.of(path);
    } else if (isPattern(name)) {
      found = matching(name);
    } else {
      throw new NoSuchFileException(name);
    }
    if (found.isEmpty()) {
      throw new IOException("no %s (%s) in %s".formatted(noun, String.join(", ", endings), name));
    }
    return found;
  }

  private static boolean isPattern(String name) {
    return PATTERN_LETTERS.matcher(name).find();
  }

  private static @Nullable Path path(String name) {
    try {
      return Path.of(name);
    } catch (InvalidPathException e) {
      return null; // on Windows a pattern is not a valid path
    }
  }

  private static List<Path> matching(String pattern) throws IOException {
    String slashes = pattern.replace('\\', '/');
    int letter = 0;
    while (!PATTERN_LETTERS.matcher(slashes.substring(letter, letter + 1)).matches()) {
      letter++;
    }
    String start = slashes.substring(0, slashes.lastIndexOf('/', letter) + 1);
    Path folder = Path.of(start);
    if (!Files.isDirectory(folder)) {
      throw new NoSuchFileException(start);
    }
    try {
      PathMatcher matcher =
          FileSystems.getDefault()
              .getPathMatcher("glob:" + anyDepth(slashes.substring(start.length())));
      return in(folder, file -> matcher.matches(folder.relativize(file)));
    } catch (PatternSyntaxException e) {
      throw new IOException(
          pattern + ": is neither a file nor a pattern: " + e.getDescription(), e);
    }
  }

  /**
   * Rewrites {@code **}{@code /} to match zero folders, too, as in shells; Java's globs require at
   * least one. Java does not allow nested groups, so patterns within braces stay as they are.
   */
  private static String anyDepth(String pattern) {
    StringBuilder wide = new StringBuilder();
    int braces = 0;
    for (int i = 0; i < pattern.length(); i++) {
      char c = pattern.charAt(i);
      braces += c == '{' ? 1 : c == '}' ? -1 : 0;
      boolean begins = i == 0 || pattern.charAt(i - 1) == '/';
      if (begins && braces == 0 && pattern.startsWith("**/", i)) {
        wide.append("{**/,}");
        i += "**/".length() - 1;
      } else {
        wide.append(c);
      }
    }
    return wide.toString();
  }

  private static List<Path> in(Path folder, Predicate<Path> wanted) throws IOException {
    List<Path> found;
    try (Stream<Path> files = Files.walk(folder)) {
      found =
          files
              .filter(file -> isFile(file) && !hidden(folder.relativize(file)))
              .filter(wanted)
              .sorted()
              .toList();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    for (Path file : found) {
      requireInside(folder, file);
    }
    return found;
  }

  /** Returns whether a path is a file or a link that leads nowhere, not a folder or a device. */
  private static boolean isFile(Path path) {
    return Files.isRegularFile(path) || !Files.exists(path);
  }

  /**
   * Requires a link to lead to a file of the folder. Else a stranger's folder could have files of
   * the user reported, with lines of them: a link to {@code ~/.m2/settings.xml} named a.x3d.
   */
  private static void requireInside(Path folder, Path file) throws IOException {
    if (Files.exists(file) && !file.toRealPath().startsWith(folder.toRealPath())) {
      throw new FileSystemException(
          file.toString(),
          null,
          "is a link to a file outside %s; to read that file, name it itself".formatted(folder));
    }
  }

  private static boolean hidden(Path path) {
    for (Path part : path) {
      if (part.toString().startsWith(".")) {
        return true;
      }
    }
    return false;
  }

  private boolean wanted(Path path) {
    String name = String.valueOf(path.getFileName()).toLowerCase(Locale.ROOT);
    return endings.stream().anyMatch(name::endsWith);
  }
}
