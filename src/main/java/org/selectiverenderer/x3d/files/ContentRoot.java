package org.selectiverenderer.x3d.files;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Which files a scene may name:
 *
 * <ul>
 *   <li>those in the folder of the scene that the user opened and below it, and those in a folder
 *       {@value #INLINE_FOLDER} beside that folder and below it, where the thesis keeps the
 *       versions of objects ({@code scenes/} and {@code inlineNodes/} are siblings);
 *   <li>those of its project: of the nearest folder above that holds a marker ({@code .git}, {@code
 *       x3d-project}), unless a folder's name on the way begins with a dot. The user's home is no
 *       project;
 *   <li>those in folders that the user allows, and on hosts that the user allows;
 *   <li>always, data in the url itself.
 * </ul>
 *
 * The same holds for the files that those name in turn. Links are followed and must not lead
 * outside.
 *
 * <p>Messages name a file relative to the scene's folder as the user wrote it. Thread-safe.
 */
public final class ContentRoot {
  /** The folder beside the scenes that holds what they inline. */
  public static final String INLINE_FOLDER = "inlineNodes";

  /** At least two letters before the colon: a single one is a drive of Windows. */
  private static final Pattern SCHEME = Pattern.compile("[a-zA-Z][a-zA-Z0-9+.-]+:");

  /** Characters above which a url is not looked at: more than the file systems' longest names. */
  static final int MAX_URL = 4096;

  /** What is wrong with a url. */
  public enum Cause {
    /** It is no name of a file. */
    NO_FILE_NAME,
    /** It names something on another machine that is not allowed, or of an unknown scheme. */
    NETWORK,
    /** The user allows it, but it could not be fetched. */
    UNREACHABLE,
    /** The file is none that the scene may name. */
    OUTSIDE,
    /** There is no such file. */
    MISSING,
    /** It is missing, but there is a file whose name differs in letter case only. */
    CASE
  }

  /** What a url means, or why it is not read. */
  public sealed interface Target {
    /**
     * @param fragment what stands behind the sign # of the url; empty for nothing
     */
    record Found(Content content, String fragment) implements Target {}

    /**
     * @param reason a clause that reads after "url ... "
     */
    record Refused(Cause cause, String reason) implements Target {}
  }

  private final Path named;
  private final Path folder;
  private final Path inlineFolder;
  private final boolean wide;
  private final Optional<Path> project;
  private final ContentAccess access;
  private final List<Path> allowed = new ArrayList<>();
  private final CaseHints hints = new CaseHints();

  /** With no more than the scene's own files and those of its project. */
  public ContentRoot(Path sceneFolder) {
    this(sceneFolder, ContentAccess.none());
  }

  /**
   * @param sceneFolder the folder of the scene that the user opened, as the user names it
   * @param access what the user allows besides
   */
  public ContentRoot(Path sceneFolder, ContentAccess access) {
    this(sceneFolder, access, Path.of(System.getProperty("user.home", "")));
  }

  ContentRoot(Path sceneFolder, ContentAccess access, Path home) {
    named = sceneFolder;
    this.access = access;
    folder = LocalUrl.real(sceneFolder);
    Path above = folder.getParent();
    // Not its real path: were it a link, it would open what it leads to.
    inlineFolder = (above == null ? folder : above).resolve(INLINE_FOLDER);
    Path realHome = LocalUrl.real(home);
    wide = ProjectFolder.wide(folder, realHome);
    project = ProjectFolder.of(folder, realHome);
    access.folders().forEach(allow -> allowed.add(LocalUrl.real(allow)));
  }

  /** What the user allows besides the scene's own files. */
  public ContentAccess access() {
    return access;
  }

  /** As {@link #resolve(String, ContentBase)}, for a file in a folder. */
  public Target resolve(String url, Path base) {
    return resolve(url, ContentBase.folder(base));
  }

  /**
   * Finds what a url means. Waits for the network where the user allows the url's host; so it is
   * called by threads that may wait.
   *
   * @param url as the file gives it, relative to {@code base} or absolute
   * @param base where relative urls of the file that names it start
   */
  public Target resolve(String url, ContentBase base) {
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
   * Notes the file of this machine that a url means, if it means one, as {@link #resolve} does, for
   * whoever does not read it. Fetches nothing.
   */
  public void note(String url, ContentBase base) {
    String location = url.strip();
    if (!DataUrl.is(location) && !WebUrl.is(location) && !overNetwork(base)) {
      resolve(url, base);
    }
  }

  private static boolean overNetwork(ContentBase base) {
    return base instanceof ContentBase.Web
        || base instanceof ContentBase.FirstOf both
            && (overNetwork(both.first()) || overNetwork(both.second()));
  }

  private Target find(String location, String fragment, ContentBase base) {
    if (base instanceof ContentBase.FirstOf both) {
      Target first = find(location, fragment, both.first());
      if (first instanceof Target.Found) {
        return first;
      }
      Target second = find(location, fragment, both.second());
      return second instanceof Target.Found ? second : first;
    }
    if (WebUrl.is(location)) {
      return web(WebUrl.of(location), fragment);
    }
    boolean absolute = FileUrl.is(location);
    if (!absolute && SCHEME.matcher(location).lookingAt()) {
      return new Target.Refused(
          Cause.NETWORK,
          "has an unknown scheme; only files, data: and, where allowed, http: and https: are read");
    }
    if (base instanceof ContentBase.Web web) {
      return absolute
          ? new Target.Refused(
              Cause.OUTSIDE, "is a file of this machine, which a file of the network may not name")
          : web(WebUrl.of(location, web.uri()), fragment);
    }
    LocalUrl.Meaning meaning =
        LocalUrl.meaning(location, absolute, ((ContentBase.Folder) base).path());
    return meaning instanceof LocalUrl.Meaning.File file
        ? local(file.path(), fragment)
        : ((LocalUrl.Meaning.None) meaning).why();
  }

  private static Target data(String location, String fragment, ContentBase base) {
    try {
      return new Target.Found(DataUrl.read(location, base), fragment);
    } catch (IOException e) {
      return new Target.Refused(Cause.NO_FILE_NAME, String.valueOf(e.getMessage()));
    }
  }

  private Target web(Optional<URI> address, String fragment) {
    if (address.isEmpty()) {
      return new Target.Refused(Cause.NO_FILE_NAME, "is no address of the network");
    }
    URI uri = address.get();
    if (!access.network().allows(uri)) {
      return new Target.Refused(
          Cause.NETWORK,
          "is on the network; --allow-net %s would allow it".formatted(uri.getHost()));
    }
    try {
      return new Target.Found(access.network().fetch(uri), fragment);
    } catch (IOException e) {
      return new Target.Refused(Cause.UNREACHABLE, String.valueOf(e.getMessage()));
    }
  }

  private Target local(Path path, String fragment) {
    Path real = LocalUrl.real(path);
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

  /** A file that is known to be one that the scene may name, or that the user named. */
  public Content content(Path real) {
    return new Content.OfFile(real, display(real));
  }

  /** Whether a scene may name a file of this machine, or files in a folder. */
  public boolean mayBeNamed(Path path) {
    Path real = LocalUrl.real(path);
    return real.startsWith(folder) && (!wide || open(folder, real))
        || real.startsWith(inlineFolder)
        || project.filter(top -> real.startsWith(top) && open(top, real)).isPresent()
        || allowed.stream().anyMatch(real::startsWith);
  }

  /** Whether no name on the way begins with a dot: there lies what is not meant to be shown. */
  private static boolean open(Path top, Path real) {
    for (Path part : top.relativize(real)) {
      if (part.toString().startsWith(".")) {
        return false;
      }
    }
    return true;
  }

  /** The folder to allow, as one would type it. */
  private String hint(Path real) {
    Path parent = real.getParent() == null ? real : real.getParent();
    String shown = display(parent);
    if (!LocalUrl.real(Path.of(shown)).equals(parent)) {
      shown = parent.toString(); // The user's name of the scene leads through a link.
    }
    String text = shown.isEmpty() ? "." : shown;
    return text.indexOf(' ') < 0 ? text : '"' + text + '"';
  }

  /** A file as messages name it. */
  public String display(Path real) {
    if (!Objects.equals(folder.getRoot(), real.getRoot())) {
      return real.toString();
    }
    return named.resolve(folder.relativize(real)).normalize().toString();
  }
}
