package org.selectiverenderer.validation.run;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.validation.SourceFile;

/** Finds the scenes that a user means by the name of a file or folder, a pattern, or {@code -}. */
public final class SceneFinder {
  /** Standard input. */
  public static final String STANDARD_INPUT = "-";

  private static final Pattern PATTERN_LETTERS = Pattern.compile("[*?\\[{]");

  private final Path base;
  private final InputStream input;

  /**
   * @param base the folder that reports name files from
   * @param input standard input
   */
  public SceneFinder(Path base, InputStream input) {
    this.base = base;
    this.input = input;
  }

  /**
   * A file itself, whatever its name; of a folder all {@code .x3d} and {@code .x3dz} files in it
   * and below, those apart whose name or folder begins with a dot; of a pattern such as {@code
   * scenes/**}{@code /*.x3d} all that match it, {@code **}{@code /} standing for any number of
   * folders and none. Links to folders are not followed.
   *
   * @throws IOException if there is no such file, or a folder cannot be read, or nothing is found
   */
  public List<SourceFile> find(String name) throws IOException {
    if (name.equals(STANDARD_INPUT)) {
      byte[] content = input.readAllBytes();
      return List.of(new SourceFile(base.resolve("standard input"), "-", content));
    }
    Path path = path(name);
    List<SourceFile> found;
    if (path != null && Files.isDirectory(path)) {
      found = in(path, SceneFinder::isScene);
    } else if (path != null && (Files.exists(path) || !isPattern(name))) {
      return List.of(SourceFile.of(path, base));
    } else if (isPattern(name)) {
      found = matching(name);
    } else {
      throw new NoSuchFileException(name);
    }
    if (found.isEmpty()) {
      throw new IOException("no scene (.x3d, .x3dz) in " + name);
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
      return null; // On Windows a pattern is no path.
    }
  }

  private List<SourceFile> matching(String pattern) throws IOException {
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
   * With {@code **}{@code /} for no folder, too, as shells and editors have it; Java's patterns
   * want one. A group cannot stand in a group, so that those within braces stay as they are.
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

  private List<SourceFile> in(Path folder, Predicate<Path> wanted) throws IOException {
    List<SourceFile> found = new ArrayList<>();
    try (Stream<Path> files = Files.walk(folder)) {
      files
          .filter(file -> !Files.isDirectory(file) && !hidden(folder.relativize(file)))
          .filter(wanted)
          .forEach(file -> found.add(SourceFile.of(file, base)));
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    return found;
  }

  private static boolean hidden(Path path) {
    for (Path part : path) {
      if (part.toString().startsWith(".")) {
        return true;
      }
    }
    return false;
  }

  private static boolean isScene(Path path) {
    String name = String.valueOf(path.getFileName()).toLowerCase(Locale.ROOT);
    return name.endsWith(".x3d") || name.endsWith(".x3dz");
  }
}
