package org.selectiverenderer.x3d.url;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import org.selectiverenderer.base.files.HomeFolder;

/**
 * Resolves the urls of a scene, and decides whether the scene may read the files that they refer
 * to. A scene may read:
 *
 * <ul>
 *   <li>files in and below the folder of the scene that the user opened, and in and below a folder
 *       {@value #INLINE_FOLDER} beside that folder, where the thesis keeps the versions of objects
 *       ({@code scenes/} and {@code inlineNodes/} are siblings);
 *   <li>files of its project, which is the nearest folder above that contains a marker ({@code
 *       .git}, {@code x3d-project}). The user's home folder is never a project;
 *   <li>files in folders and on hosts that the user allows;
 *   <li>the data in data: urls.
 * </ul>
 *
 * Files and folders whose name begins with a dot are left out, except where the scene lies in such
 * a folder or the user allows it: they hold what programs and users keep to themselves. The same
 * holds for urls in those files. Symbolic links are followed and must not lead outside.
 *
 * <p>Messages name a file relative to the scene's folder as the user wrote it. Thread-safe.
 */
public final class UrlResolver {
  /** The name of the folder beside the scenes for the files that they inline. */
  public static final String INLINE_FOLDER = "inlineNodes";

  /** A scheme has at least two letters; a single letter before a colon is a Windows drive. */
  private static final Pattern SCHEME = Pattern.compile("[a-zA-Z][a-zA-Z0-9+.-]+:");

  /** The maximum length of a url, more than the longest path of any file system. */
  static final int MAX_URL = 4096;

  /** The reasons why a url cannot be read. */
  public enum Cause {
    /** It is not a file name. */
    NO_FILE_NAME,
    /** It refers to a host that is not allowed, or has an unknown scheme. */
    NETWORK,
    /** Its host is allowed, but it could not be fetched. */
    UNREACHABLE,
    /** The scene may not read the file. */
    OUTSIDE,
    /** The file does not exist. */
    MISSING,
    /** The file does not exist, but one whose name differs in letter case only. */
    CASE
  }

  /** The result of resolving a url. */
  public sealed interface Target {
    /**
     * The content of a url.
     *
     * @param fragment the part of the url after the sign #; empty if there is none
     */
    record Found(UrlContent content, String fragment) implements Target {}

    /**
     * A url that cannot be read.
     *
     * @param reason a predicate that follows "url ... "
     */
    record Refused(Cause cause, String reason) implements Target {}
  }

  private final Path named;
  private final Path folder;
  private final Path inlineFolder;
  private final boolean wide;
  private final Optional<Path> project;
  private final ContentAccessPolicy access;
  private final List<Path> allowed = new ArrayList<>();
  private final CaseMismatchDetector hints = new CaseMismatchDetector();

  /** Creates a resolver for the scene's own files and those of its project only. */
  public UrlResolver(Path sceneFolder) {
    this(sceneFolder, ContentAccessPolicy.none());
  }

  /**
   * Creates a resolver.
   *
   * @param sceneFolder the folder of the scene that the user opened, as the user names it
   * @param access what the user allows in addition
   */
  public UrlResolver(Path sceneFolder, ContentAccessPolicy access) {
    this(sceneFolder, access, HomeFolder.ofUser());
  }

  UrlResolver(Path sceneFolder, ContentAccessPolicy access, Path home) {
    named = sceneFolder;
    this.access = access;
    folder = LocalPathResolver.real(sceneFolder);
    Path above = folder.getParent();
    // not its real path: a link would give access to its target
    inlineFolder = (above == null ? folder : above).resolve(INLINE_FOLDER);
    Path realHome = LocalPathResolver.real(home);
    wide = ProjectFolder.wide(folder, realHome);
    project = ProjectFolder.of(folder, realHome);
    access.folders().forEach(allow -> allowed.add(LocalPathResolver.real(allow)));
  }

  /** Returns what the user allows in addition to the scene's own files. */
  public ContentAccessPolicy access() {
    return access;
  }

  /** Resolves a url as {@link #resolve(String, BaseUrl)}, relative to a folder. */
  public Target resolve(String url, Path base) {
    return resolve(url, BaseUrl.folder(base));
  }

  /**
   * Resolves a url. Blocks for the network if the url's host is allowed; must be called by threads
   * that may block.
   *
   * @param url the url in the file, relative to {@code base} or absolute
   * @param base the base of the relative urls of the file that contains it
   */
  public Target resolve(String url, BaseUrl base) {
    String trimmed = url.strip();
    int at = DataUrl.is(trimmed) ? DataUrl.fragment(trimmed) : trimmed.indexOf('#');
    String location = at < 0 ? trimmed : trimmed.substring(0, at);
    String fragment = at < 0 ? "" : trimmed.substring(at + 1);
    if (DataUrl.is(location)) {
      return data(location, fragment, base);
    }
    if (trimmed.length() > MAX_URL) {
      return new Target.Refused(Cause.NO_FILE_NAME, "is too long for a file name");
    }
    if (location.isEmpty()) {
      return new Target.Refused(Cause.NO_FILE_NAME, "names no file");
    }
    return find(location, fragment, base);
  }

  /**
   * Records the local file that a url refers to, if any, as {@link #resolve} does, for callers that
   * do not read it. Fetches nothing.
   */
  public void note(String url, BaseUrl base) {
    if (!DataUrl.is(url.strip()) && !onNetwork(url, base)) {
      resolve(url, base);
    }
  }

  /** Returns whether a url may refer to the network, by itself or by its base. */
  public static boolean onNetwork(String url, BaseUrl base) {
    return HttpUrl.is(url.strip()) || overNetwork(base);
  }

  private static boolean overNetwork(BaseUrl base) {
    return base instanceof BaseUrl.Web
        || base instanceof BaseUrl.FirstOf both
            && (overNetwork(both.first()) || overNetwork(both.second()));
  }

  private Target find(String location, String fragment, BaseUrl base) {
    if (base instanceof BaseUrl.FirstOf both) {
      Target first = find(location, fragment, both.first());
      if (first instanceof Target.Found) {
        return first;
      }
      Target second = find(location, fragment, both.second());
      return second instanceof Target.Found ? second : first;
    }
    if (HttpUrl.is(location)) {
      return web(HttpUrl.of(location), fragment);
    }
    boolean absolute = FileUrl.is(location);
    if (!absolute && SCHEME.matcher(location).lookingAt()) {
      return new Target.Refused(
          Cause.NETWORK,
          "has an unknown scheme; only files, data: and, where allowed, http: and https: are read");
    }
    if (base instanceof BaseUrl.Web web) {
      return absolute
          ? new Target.Refused(
              Cause.OUTSIDE, "is a local file, to which a file from the network may not refer")
          : web(HttpUrl.of(location, web.uri()), fragment);
    }
    LocalPathResolver.Meaning meaning =
        LocalPathResolver.meaning(location, absolute, ((BaseUrl.Folder) base).path());
    return meaning instanceof LocalPathResolver.Meaning.File file
        ? local(file.path(), fragment)
        : ((LocalPathResolver.Meaning.None) meaning).why();
  }

  private static Target data(String location, String fragment, BaseUrl base) {
    try {
      return new Target.Found(DataUrl.read(location, base), fragment);
    } catch (IOException e) {
      return new Target.Refused(Cause.NO_FILE_NAME, String.valueOf(e.getMessage()));
    }
  }

  private Target web(Optional<URI> address, String fragment) {
    if (address.isEmpty()) {
      return new Target.Refused(Cause.NO_FILE_NAME, "is not a valid network address");
    }
    URI uri = address.get();
    if (!access.network().allows(uri)) {
      return new Target.Refused(
          Cause.NETWORK,
          "is on the network; --allow-net %s would allow it".formatted(HostPattern.allowing(uri)));
    }
    try {
      return new Target.Found(access.network().fetch(uri), fragment);
    } catch (IOException e) {
      return new Target.Refused(Cause.UNREACHABLE, String.valueOf(e.getMessage()));
    }
  }

  private Target local(Path path, String fragment) {
    Path real = LocalPathResolver.real(path);
    if (!mayBeNamed(real)) {
      return new Target.Refused(
          Cause.OUTSIDE,
          "points outside the folders this scene may name; --allow %s would allow it"
              .formatted(hint(real)));
    }
    if (Files.isDirectory(real)) {
      return new Target.Refused(Cause.NO_FILE_NAME, "is a folder");
    }
    if (!Files.isRegularFile(real)) {
      String similar = hints.of(path);
      return new Target.Refused(
          similar.isEmpty() ? Cause.MISSING : Cause.CASE, "is missing" + similar);
    }
    access.named().add(real);
    return new Target.Found(content(real), fragment);
  }

  /** Returns the content of a file that is known to be allowed, or that the user named. */
  public UrlContent content(Path real) {
    return new UrlContent.OfFile(real, display(real));
  }

  /** Returns whether a scene may read a local file, or files in a folder. */
  public boolean mayBeNamed(Path path) {
    Path real = LocalPathResolver.real(path);
    return open(folder, real)
        || open(inlineFolder, real)
        || project.filter(top -> open(top, real)).isPresent()
        || allowed.stream().anyMatch(real::startsWith);
  }

  /** Returns whether the scene's folder has the user's home in it, so that it hides files. */
  boolean isWide() {
    return wide;
  }

  /**
   * Returns whether a file is in or below a folder, and no name on the path between them begins
   * with a dot, which marks private content.
   */
  private static boolean open(Path top, Path real) {
    if (!real.startsWith(top)) {
      return false;
    }
    for (Path part : top.relativize(real)) {
      if (part.toString().startsWith(".")) {
        return false;
      }
    }
    return true;
  }

  /** Returns the folder to allow, as one would type it. */
  private String hint(Path real) {
    Path parent = real.getParent() == null ? real : real.getParent();
    String shown = display(parent);
    if (!LocalPathResolver.real(Path.of(shown)).equals(parent)) {
      shown = parent.toString(); // the user's path of the scene leads through a link
    }
    String text = shown.isEmpty() ? "." : shown;
    return text.indexOf(' ') < 0 ? text : '"' + text + '"';
  }

  /** Returns the name of a file for messages. */
  public String display(Path real) {
    if (!Objects.equals(folder.getRoot(), real.getRoot())) {
      return real.toString();
    }
    return named.resolve(folder.relativize(real)).normalize().toString();
  }

  /**
   * Finds the project folder of a scene: its own folder or the nearest one above it that contains a
   * marker. A user's home folder and those above it are never projects, since one scene must not
   * have access to all of a user's files.
   */
  private static final class ProjectFolder {
    /**
     * Names that mark a project: that of a git repository, and an empty file for other projects.
     */
    static final List<String> MARKERS = List.of(".git", "x3d-project");

    private ProjectFolder() {}

    /**
     * Returns the project folder, if any.
     *
     * @param folder the real path of the scene's folder
     * @param home the real path of the user's home folder
     */
    static Optional<Path> of(Path folder, Path home) {
      for (Path at = folder; at != null && !wide(at, home); at = at.getParent()) {
        if (MARKERS.stream().map(at::resolve).anyMatch(Files::exists)) {
          return Optional.of(at);
        }
      }
      return Optional.empty();
    }

    /** Returns whether a folder contains the user's home folder, or is the root of a disk. */
    static boolean wide(Path folder, Path home) {
      return folder.getParent() == null || home.startsWith(folder);
    }
  }
}
