package org.selectiverenderer.x3d.files;

import java.io.IOException;
import java.net.URI;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Which files a scene may name: those in the folder of the scene that the user opened and below it,
 * and those in a folder {@value #INLINE_FOLDER} beside that folder and below it, where the thesis
 * keeps the versions of objects ({@code scenes/} and {@code inlineNodes/} are siblings). The same
 * holds for the files that those name in turn. Links are followed and must not lead outside. Never
 * the network.
 *
 * <p>Messages name a file relative to the scene's folder as the user wrote it.
 */
public final class ContentRoot {
  public static final String INLINE_FOLDER = "inlineNodes";

  /** At least two letters before the colon: a single one is a drive of Windows. */
  private static final Pattern SCHEME = Pattern.compile("[a-zA-Z][a-zA-Z0-9+.-]+:");

  private static final Pattern FILE_SCHEME = Pattern.compile("(?i)file:");

  /** What Windows takes for a file of another computer: two slashes, of whichever kind. */
  private static final Pattern SHARE = Pattern.compile("[/\\\\]{2}.*", Pattern.DOTALL);

  private static final Pattern ENCODED = Pattern.compile("(?s)(?:[^%]++|%[0-9a-fA-F]{2})*+");

  /** Characters above which a url is not looked at: more than the file systems' longest names. */
  static final int MAX_URL = 4096;

  private static final String NETWORK =
      "is on the network or has an unknown scheme; only local files are read";

  /** What is wrong with a url. */
  public enum Cause {
    /** It is no name of a file. */
    NO_FILE_NAME,
    /** It names something on another machine, or of a scheme that is not read. */
    NETWORK,
    /** The file is none that the scene may name. */
    OUTSIDE,
    MISSING,
    /** It is missing, but there is a file whose name differs in letter case only. */
    CASE
  }

  /** Why a url is not opened, or the file that it names. */
  public sealed interface Target {
    record File(Path path) implements Target {}

    /**
     * @param reason a clause that reads after "url ... "
     */
    record Refused(Cause cause, String reason) implements Target {}
  }

  private final Path named;
  private final Path folder;
  private final Path inlineFolder;

  /** Folders listed for a hint, once each: a scene may name very many files that are missing. */
  private final Map<Path, Map<String, List<String>>> listed = new ConcurrentHashMap<>();

  /**
   * @param sceneFolder the folder of the scene that the user opened, as the user names it
   */
  public ContentRoot(Path sceneFolder) {
    named = sceneFolder;
    folder = real(sceneFolder);
    Path above = folder.getParent();
    // Not its real path: were it a link, it would open what it leads to.
    inlineFolder = (above == null ? folder : above).resolve(INLINE_FOLDER);
  }

  /**
   * @param url as the file gives it, relative to {@code base} or absolute
   * @param base the folder of the file that names it
   */
  public Target resolve(String url, Path base) {
    String trimmed = url.strip();
    if (trimmed.length() > MAX_URL) {
      return new Target.Refused(Cause.NO_FILE_NAME, "is too long for a file name");
    }
    int fragment = trimmed.indexOf('#');
    String location = fragment < 0 ? trimmed : trimmed.substring(0, fragment);
    boolean absolute = FILE_SCHEME.matcher(location).lookingAt();
    if (!absolute && SCHEME.matcher(location).lookingAt()) {
      return new Target.Refused(Cause.NETWORK, NETWORK);
    }
    if (location.isEmpty()) {
      return new Target.Refused(Cause.NO_FILE_NAME, "names no file");
    }
    Path path;
    try {
      if (share(location, absolute)) {
        return new Target.Refused(Cause.NETWORK, NETWORK);
      }
      path = absolute ? Path.of(URI.create(location)) : relative(location, base);
    } catch (IllegalArgumentException | FileSystemNotFoundException e) {
      return new Target.Refused(Cause.NO_FILE_NAME, "is not a file name");
    }
    Path real = real(path);
    if (!real.startsWith(folder) && !real.startsWith(inlineFolder)) {
      return new Target.Refused(Cause.OUTSIDE, "points outside the scene's folder");
    }
    if (Files.isDirectory(real)) {
      return new Target.Refused(Cause.NO_FILE_NAME, "is a folder");
    }
    if (!Files.isRegularFile(real)) {
      String similar = similar(path);
      return new Target.Refused(
          similar.isEmpty() ? Cause.MISSING : Cause.CASE, "is missing" + similar);
    }
    return new Target.File(real);
  }

  /**
   * Whether a url names another computer. Asked before a file system is, which would call there.
   *
   * @throws IllegalArgumentException when the url is malformed
   */
  private static boolean share(String location, boolean absolute) {
    if (absolute) {
      URI uri = URI.create(location);
      return uri.getAuthority() != null || uri.getPath() != null && isShare(uri.getPath());
    }
    return isShare(location) || isShare(decoded(location));
  }

  private static boolean isShare(String path) {
    return SHARE.matcher(path).matches();
  }

  /** As it is where its signs % begin no code. */
  private static String decoded(String location) {
    if (location.indexOf('%') < 0 || !ENCODED.matcher(location).matches()) {
      return location;
    }
    return URLDecoder.decode(location.replace("+", "%2B"), StandardCharsets.UTF_8);
  }

  /** Urls are percent-encoded; yet a file that has the name as it is written is meant first. */
  private static Path relative(String location, Path base) {
    Path literal = base.resolve(location.replace('\\', '/'));
    if (location.indexOf('%') < 0 || Files.exists(literal)) {
      return literal;
    }
    return base.resolve(decoded(location).replace('\\', '/'));
  }

  /** Follows links, so that none leads outside; a file that does not exist is only normalised. */
  private static Path real(Path path) {
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

  /** A hint for a name that differs in case only, which works on some systems and not on others. */
  private String similar(Path path) {
    Path parent = path.getParent();
    Path name = path.getFileName();
    if (parent == null || name == null) {
      return "";
    }
    return listed
        .computeIfAbsent(parent, ContentRoot::list)
        .getOrDefault(folded(name.toString()), List.of())
        .stream()
        .filter(file -> file.equalsIgnoreCase(name.toString()) && !file.equals(name.toString()))
        .min(String::compareTo)
        .map(file -> " (there is " + file + ", which differs in upper and lower case)")
        .orElse("");
  }

  /** The names in a folder, by what they are in one case. */
  private static Map<String, List<String>> list(Path folder) {
    if (!Files.isDirectory(folder)) {
      return Map.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> String.valueOf(file.getFileName()))
          .collect(Collectors.groupingBy(ContentRoot::folded));
    } catch (IOException e) {
      return Map.of(); // It stays without a hint where the folder cannot be listed.
    }
  }

  private static String folded(String name) {
    return name.toUpperCase(Locale.ROOT).toLowerCase(Locale.ROOT);
  }

  /** A file as messages name it. */
  public String display(Path real) {
    if (!Objects.equals(folder.getRoot(), real.getRoot())) {
      return real.toString();
    }
    return named.resolve(folder.relativize(real)).normalize().toString();
  }
}
