package org.selectiverenderer.polygon.count;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.geometry.tessellate.Tessellator;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentAccess;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;
import org.selectiverenderer.x3d.read.FileLibraries;
import org.selectiverenderer.x3d.read.Libraries;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * Reads a scene and everything it inlines and measures its geometry, on all processors. Textures
 * are not opened. One object serves one scene.
 */
final class SceneFiles {
  private final X3dReader reader = new X3dReader(NodeCatalogue.load());
  private final Tessellator tessellator = new Tessellator();
  private final Map<String, CompletableFuture<Optional<SceneFile>>> files =
      new ConcurrentHashMap<>();
  private final ConcurrentLinkedQueue<CompletableFuture<?>> tasks = new ConcurrentLinkedQueue<>();
  private final ExecutorService executor;
  private final ContentRoot root;
  private final ContentBase base;
  private final Libraries libraries;

  private SceneFiles(Path nameFolder, ContentAccess access, ExecutorService executor) {
    base = ContentBase.folder(nameFolder);
    this.executor = executor;
    this.root = new ContentRoot(nameFolder, access);
    libraries = new FileLibraries(reader, root);
  }

  /**
   * Reads a scene.
   *
   * @param access what it may name besides its own files
   * @throws IOException if the file itself cannot be read, with a message of one line
   */
  static SceneFile read(Path scene, ContentAccess access) throws IOException {
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
      return new SceneFiles(parent == null ? Path.of("") : parent, access, executor).load(scene);
    } finally {
      executor.shutdownNow();
    }
  }

  private SceneFile load(Path scene) throws IOException {
    Problems problems = new Problems();
    SceneFile first = new SceneFile(reader.with(libraries, base).read(scene, problems), problems);
    files.put(scene.toRealPath().toString(), CompletableFuture.completedFuture(Optional.of(first)));
    follow(first, base);
    for (CompletableFuture<?> task = tasks.poll(); task != null; task = tasks.poll()) {
      task.join();
    }
    return first;
  }

  /** Starts a task for each geometry and each Inline of a file. */
  private void follow(SceneFile file, ContentBase from) {
    Set<ParsedNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    file.file().nodes().forEach(node -> follow(node, file, from, seen));
  }

  private void follow(ParsedNode node, SceneFile file, ContentBase from, Set<ParsedNode> seen) {
    if (!seen.add(node)) {
      return;
    }
    if (Structure.isInline(node)) {
      if (node.bool("load")) {
        inline(node, file, from);
      }
    } else if (Structure.isShape(node)) {
      Structure.geometry(node).filter(seen::add).ifPresent(geometry -> measure(geometry, file));
    } else {
      Structure.children(node).forEach(child -> follow(child, file, from, seen));
    }
  }

  private void inline(ParsedNode inline, SceneFile file, ContentBase from) {
    UrlChoice choice = UrlChoice.of(inline, root, inline.base(from), "the Inline is left out");
    if (choice instanceof UrlChoice.Found found) {
      file.inlines().put(inline, content(found.content(), inline, file));
    } else {
      file.problems().add(((UrlChoice.None) choice).problem());
    }
  }

  private void measure(ParsedNode geometry, SceneFile file) {
    tasks.add(
        CompletableFuture.runAsync(
            () ->
                tessellator
                    .tessellate(geometry, file.problems())
                    .ifPresent(mesh -> file.sizes().put(geometry, Size.of(geometry, mesh))),
            executor));
  }

  private CompletableFuture<Optional<SceneFile>> content(
      Content content, ParsedNode inline, SceneFile requester) {
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

  private Optional<SceneFile> inlined(Content content, Location requestedBy, Problems requester) {
    String name = content.name();
    Problems problems = new Problems();
    try (var in = content.open()) {
      SceneFile file =
          new SceneFile(
              reader.with(libraries, content.base()).read(name, in, content.size(), problems),
              problems);
      follow(file, content.base());
      return Optional.of(file);
    } catch (IOException e) {
      requester.error(
          requestedBy, "%s cannot be read and is left out (%s)".formatted(name, e.getMessage()));
      return Optional.empty();
    }
  }
}
