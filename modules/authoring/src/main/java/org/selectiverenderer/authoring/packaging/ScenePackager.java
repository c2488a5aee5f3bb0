package org.selectiverenderer.authoring.packaging;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.packaging.SceneFileReader.SceneFile;
import org.selectiverenderer.authoring.packaging.ScenePackage.LeftOut;
import org.selectiverenderer.authoring.packaging.UrlFields.UrlField;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HttpFetcher;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Collects the files that a scene names: those of its urls, and, for Inlines, prototypes and
 * models, those that these name in turn. A file is taken only if the scene may read it. Any thread
 * may use it.
 */
public final class ScenePackager {
  /** The largest number of files of a package. */
  static final int MOST_FILES = 10_000;

  private final SceneFileReader reader;
  private final UrlFields fields;
  private final UrlResolver resolver;
  private final PackageLayout layout;
  private final BooleanSupplier cancelled;
  private final Map<Path, PackagedFile> files = new LinkedHashMap<>();
  private final Set<Path> seen = new LinkedHashSet<>();
  private final Deque<Path> waiting = new ArrayDeque<>();
  private final List<LeftOut> left = new ArrayList<>();

  /**
   * @param folder the folder of the scene, against which its urls are resolved
   * @param access further folders that the scene may read from; hosts are not asked
   * @param cancelled whether the work is to end
   */
  public ScenePackager(
      NodeCatalogue catalogue,
      Path folder,
      ContentAccessPolicy access,
      PackageLayout layout,
      BooleanSupplier cancelled) {
    ContentAccessPolicy local = new ContentAccessPolicy(access.folders(), HttpFetcher.none());
    this.resolver = new UrlResolver(folder, local);
    this.reader = new SceneFileReader(catalogue, resolver);
    this.fields = new UrlFields(catalogue);
    this.layout = layout;
    this.cancelled = cancelled;
  }

  /**
   * Collects a scene in X3D XML and its files.
   *
   * @param file the scene's file, which is not read
   * @param scene its text, which may differ from the file
   * @param target the scene's own place in the target folder
   * @throws IOException with a sentence, if a file cannot be read or there are too many
   */
  public ScenePackage collect(Path file, DocumentSnapshot scene, Path target) throws IOException {
    Path real = real(file);
    layout.place(real, target);
    seen.add(real);
    Optional<SceneFile> read = reader.text(file, scene);
    List<TextEdit> edits = read.isPresent() ? edits(read.get(), real, target) : List.of();
    byte[] bytes = read.isPresent() ? read.get().bytes(edits) : scene.bytes();
    while (!waiting.isEmpty()) {
      if (cancelled.getAsBoolean()) {
        throw new CancellationException();
      }
      add(waiting.remove());
    }
    return new ScenePackage(
        new PackagedFile(target, file, Optional.of(bytes)),
        List.copyOf(files.values()),
        left,
        edits);
  }

  /** Adds a file, and has those added that it names. */
  private void add(Path real) throws IOException {
    if (layout.stays(real)) {
      return;
    }
    if (files.size() >= MOST_FILES) {
      throw new IOException(
          "the scene names more than %d files; a package of so many is not made"
              .formatted(MOST_FILES));
    }
    Path target = layout.of(real);
    Optional<SceneFile> scene = reader.file(real);
    List<TextEdit> edits = scene.isPresent() ? edits(scene.get(), real, target) : List.of();
    Optional<byte[]> changed =
        edits.isEmpty() ? Optional.empty() : Optional.of(scene.get().bytes(edits));
    files.put(real, new PackagedFile(target, real, changed));
    for (Path own : reader.filesOfModel(real)) {
      Path wanted = target.resolveSibling(real.getParent().relativize(own)).normalize();
      if (!take(own).equals(wanted)) {
        left.add(
            new LeftOut(
                resolver.display(real),
                resolver.display(own),
                "does not keep its name, or its place beside or below the model that names it"));
      }
    }
  }

  /** Returns the place of a file, which is added unless it has been. */
  private Path take(Path real) {
    if (seen.add(real)) {
      waiting.add(real);
    }
    return layout.of(real);
  }

  /** Returns the changes of the urls in a file that gets a place. */
  private List<TextEdit> edits(SceneFile scene, Path real, Path target) {
    List<TextEdit> edits = new ArrayList<>();
    BaseUrl base = BaseUrl.folder(real.getParent());
    for (UrlField field : fields.of(scene.elements())) {
      List<String> now = new ArrayList<>();
      Optional<LeftOut> reason = Optional.empty();
      boolean taken = false;
      for (String url : field.urls()) {
        UrlResolver.Target found = resolver.resolve(url, base);
        if (found instanceof UrlResolver.Target.Found file && file.content().file().isPresent()) {
          taken = true;
          now.add(turned(url, target, take(file.content().file().get())));
        } else {
          taken |= found instanceof UrlResolver.Target.Found; // a data: url
          now.add(url);
          if (found instanceof UrlResolver.Target.Refused refused && !program(url)) {
            reason =
                reason.or(
                    () -> Optional.of(new LeftOut(resolver.display(real), url, refused.reason())));
          }
        }
      }
      if (!taken) {
        reason.ifPresent(left::add);
      }
      if (!now.equals(field.urls())) {
        Optional<List<TextEdit>> changed = scene.changed(field, now);
        if (changed.isPresent()) {
          edits.addAll(changed.get());
        } else {
          left.add(
              new LeftOut(
                  resolver.display(real),
                  field.urls().get(0),
                  "cannot be changed in this file, which will not find it"));
        }
      }
    }
    return edits;
  }

  /** Returns whether a url holds a program, as that of a Script may (X3D 4.0, 9.2.3). */
  private static boolean program(String url) {
    return url.strip().matches("(?is)(ecmascript|javascript|vrmlscript|java):.*")
        || url.strip().startsWith("#");
  }

  /** Returns the url by which a file at one place names a file at another. */
  private static String turned(String url, Path from, Path to) {
    int at = url.indexOf('#');
    String location = at < 0 ? url : url.substring(0, at);
    String fragment = at < 0 ? "" : url.substring(at);
    Path folder = from.getParent() == null ? Path.of("") : from.getParent();
    if (means(location.strip(), folder, to)) {
      return url;
    }
    return UrlRelativizer.between(folder, to) + fragment;
  }

  /** Returns whether a relative url names a place already. */
  private static boolean means(String location, Path folder, Path to) {
    if (location.startsWith("/") || location.contains(":")) {
      return false;
    }
    for (String path : List.of(location, decoded(location))) {
      try {
        if (folder.resolve(path.replace('\\', '/')).normalize().equals(to.normalize())) {
          return true;
        }
      } catch (java.nio.file.InvalidPathException e) {
        continue; // the other spelling may be a path
      }
    }
    return false;
  }

  private static String decoded(String location) {
    try {
      return java.net.URLDecoder.decode(location.replace("+", "%2B"), StandardCharsets.UTF_8);
    } catch (IllegalArgumentException e) {
      return location;
    }
  }

  private static Path real(Path file) {
    try {
      return file.toRealPath();
    } catch (IOException e) {
      return file.toAbsolutePath().normalize(); // not saved yet
    }
  }

  /** Reads the first bytes of a file. */
  static byte[] head(Path file, int most) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      return in.readNBytes(most);
    }
  }
}
