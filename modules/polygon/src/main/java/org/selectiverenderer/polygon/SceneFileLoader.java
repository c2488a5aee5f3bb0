package org.selectiverenderer.polygon;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiFunction;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.PrototypeLibraryProvider;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.tessellate.Tessellator;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Reads a scene and all files that it inlines and measures their geometry, on all processors. Of
 * textures only the sizes are read, and when they are asked for. Each instance reads one scene.
 */
final class SceneFileLoader {
  private final X3dReader reader = new X3dReader(NodeCatalogue.load());
  private final Tessellator tessellator = new Tessellator();
  private final Map<String, CompletableFuture<Optional<SceneFile>>> files =
      new ConcurrentHashMap<>();
  private final ConcurrentLinkedQueue<CompletableFuture<?>> tasks = new ConcurrentLinkedQueue<>();
  private final ExecutorService executor;
  private final UrlResolver root;
  private final TexturePictureReader pictures;
  private final BaseUrl base;
  private final PrototypeLibraryProvider libraries;
  private final GeometryMeasurementCache kept;
  private final AtomicInteger filesRead = new AtomicInteger();

  private SceneFileLoader(
      Path nameFolder,
      ContentAccessPolicy access,
      GeometryMeasurementCache kept,
      ExecutorService executor) {
    this.kept = kept;
    base = BaseUrl.folder(nameFolder);
    this.executor = executor;
    this.root = new UrlResolver(nameFolder, access);
    pictures = new TexturePictureReader(root);
    libraries = new PrototypeLibraryLoader(reader, root);
  }

  /**
   * Reads a scene.
   *
   * @param access further folders and hosts that the scene may refer to
   * @throws IOException if the file itself cannot be read, with a message of one line
   */
  static SceneFile read(Path scene, ContentAccessPolicy access) throws IOException {
    return measured(
        scene,
        access,
        new GeometryMeasurementCache(),
        files -> {
          ProblemCollector problems = new ProblemCollector();
          X3dReader reader = files.reader.with(files.libraries, files.base);
          return files.load(
              scene,
              new SceneFile(reader.read(scene, problems), problems, files.pictures(files.base)));
        });
  }

  /**
   * The result of reading a scene.
   *
   * @param filesRead number of files that were read, the scene included
   */
  record Read(SceneFile file, int filesRead) {}

  /**
   * Reads a scene from its text, and those of its inlined files that are not cached.
   *
   * @param scene the file where the scene is, or would be
   * @param name name of the scene in messages
   * @param kept the cache of files, to which the files read are added
   */
  static Read read(
      Path scene,
      String name,
      byte[] text,
      ContentAccessPolicy access,
      GeometryMeasurementCache kept)
      throws IOException {
    return measured(
        scene,
        access,
        kept,
        files -> {
          ProblemCollector problems = new ProblemCollector();
          X3dReader reader = files.reader.with(files.libraries, files.base);
          ByteArrayInputStream in = new ByteArrayInputStream(text);
          SceneFile first =
              new SceneFile(
                  reader.read(name, in, text.length, problems),
                  problems,
                  files.pictures(files.base));
          files.filesRead.incrementAndGet();
          return new Read(files.load(scene, first), files.filesRead.get());
        });
  }

  private BiFunction<ParsedNode, List<String>, Optional<TexturePicture>> pictures(BaseUrl from) {
    TexturePictureReader sizes = pictures; // Kept files must not keep this loader with its scene.
    return (texture, urls) -> sizes.picture(texture, urls, from);
  }

  private interface Loading<T> {
    T load(SceneFileLoader files) throws IOException;
  }

  private static <T> T measured(
      Path scene, ContentAccessPolicy access, GeometryMeasurementCache kept, Loading<T> loading)
      throws IOException {
    ExecutorService executor =
        Executors.newFixedThreadPool(
            Runtime.getRuntime().availableProcessors(),
            task -> {
              Thread thread = new Thread(task, "polygon-counter");
              thread.setDaemon(true);
              return thread;
            });
    try {
      Path parent = scene.getParent();
      return loading.load(
          new SceneFileLoader(parent == null ? Path.of("") : parent, access, kept, executor));
    } finally {
      executor.shutdownNow();
    }
  }

  private SceneFile load(Path scene, SceneFile first) throws IOException {
    String key = Files.exists(scene) ? scene.toRealPath().toString() : scene.toString();
    files.put(key, CompletableFuture.completedFuture(Optional.of(first)));
    follow(first, base);
    for (CompletableFuture<?> task = tasks.poll(); task != null; task = tasks.poll()) {
      task.join();
    }
    return first;
  }

  /** Starts a task for each geometry and each Inline of a file. */
  private void follow(SceneFile file, BaseUrl from) {
    Set<ParsedNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    file.file().nodes().forEach(node -> follow(node, file, from, seen));
    NodeTraversal.visit(file.file().nodes(), node -> note(node, from));
  }

  /**
   * Notes the files of textures, sounds and films: they have no polygons, but must not be
   * overwritten.
   */
  private void note(ParsedNode node, BaseUrl from) {
    if (!DrawableNodeClassifier.isInline(node) && node.type().field("url").isPresent()) {
      for (String url : node.strings("url")) {
        root.note(url, node.base(from));
      }
    }
  }

  private void follow(ParsedNode node, SceneFile file, BaseUrl from, Set<ParsedNode> seen) {
    if (!seen.add(node)) {
      return;
    }
    if (DrawableNodeClassifier.isInline(node)) {
      if (node.bool("load")) {
        inline(node, file, from);
      }
    } else if (DrawableNodeClassifier.isShape(node)) {
      DrawableNodeClassifier.geometry(node)
          .filter(seen::add)
          .ifPresent(geometry -> measure(geometry, file));
    } else {
      DrawableNodeClassifier.children(node).forEach(child -> follow(child, file, from, seen));
    }
  }

  private void inline(ParsedNode inline, SceneFile file, BaseUrl from) {
    ResolvedUrlContent choice =
        ResolvedUrlContent.of(inline, root, inline.base(from), "the Inline is left out");
    if (choice instanceof ResolvedUrlContent.Found found) {
      file.inlines().put(inline, content(found.content(), inline, file));
    } else {
      file.problems().add(((ResolvedUrlContent.None) choice).problem());
    }
  }

  private void measure(ParsedNode geometry, SceneFile file) {
    if (file.sizes().containsKey(geometry)) {
      return; // already measured by an earlier count
    }
    tasks.add(
        CompletableFuture.runAsync(
            () ->
                tessellator
                    .tessellate(geometry, file.problems())
                    .ifPresent(mesh -> file.sizes().put(geometry, GeometrySize.of(geometry, mesh))),
            executor));
  }

  private CompletableFuture<Optional<SceneFile>> content(
      UrlContent content, ParsedNode inline, SceneFile requester) {
    return files.computeIfAbsent(
        content.key(),
        wanted -> {
          CompletableFuture<Optional<SceneFile>> reading =
              CompletableFuture.supplyAsync(
                  () -> inlined(content, inline.location(), requester.problems()), executor);
          tasks.add(reading);
          return reading;
        });
  }

  private Optional<SceneFile> inlined(
      UrlContent content, SourceLocation requestedBy, ProblemCollector requester) {
    Optional<SceneFile> known =
        kept.find(content).map(file -> file.again(pictures(content.base())));
    known.ifPresent(file -> follow(file, content.base()));
    return known.or(() -> fresh(content, requestedBy, requester));
  }

  private Optional<SceneFile> fresh(
      UrlContent content, SourceLocation requestedBy, ProblemCollector requester) {
    filesRead.incrementAndGet();
    Optional<String> stamp = GeometryMeasurementCache.stamp(content);
    String name = content.name();
    ProblemCollector problems = new ProblemCollector();
    try (var in = content.open()) {
      SceneFile file =
          new SceneFile(
              reader.with(libraries, content.base()).read(name, in, content.size(), problems),
              problems,
              pictures(content.base()));
      kept.keep(content, stamp, file);
      follow(file, content.base());
      return Optional.of(file);
    } catch (IOException e) {
      requester.error(
          requestedBy, "%s cannot be read and is left out (%s)".formatted(name, e.getMessage()));
      return Optional.empty();
    }
  }
}
