package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.geometry.tessellate.Tessellator;
import org.selectiverenderer.runtime.loading.FileContent.Outcome;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * Reads a file and everything it names, all at once: each file, each geometry and each image is a
 * task of its own. One loader serves one load.
 */
final class FileLoader {
  private final X3dReader reader;
  private final Tessellator tessellator;
  private final TaskGroup tasks;
  private final ContentRoot root;
  private final ImageFiles images;
  private final Map<Path, CompletableFuture<Outcome>> files = new ConcurrentHashMap<>();

  FileLoader(X3dReader reader, Tessellator tessellator, TaskGroup tasks, ContentRoot root) {
    this.reader = reader;
    this.tessellator = tessellator;
    this.tasks = tasks;
    this.root = root;
    images = new ImageFiles(root);
  }

  /**
   * Reads the stream of the first file on the calling thread, which can be caught up with what it
   * names when the tasks have ended.
   *
   * @param name for messages
   * @param path the real file, or the folder it counts as being in
   * @param folder against which its urls are resolved
   * @param size of the stream if it is known, else 0
   */
  FileContent first(String name, InputStream in, long size, Path path, Path folder)
      throws IOException {
    Problems problems = new Problems();
    X3dFile file = reader.read(name, in, size, problems);
    FileContent content = new FileContent(path, folder, file);
    content.problems().addAll(problems.list());
    files.put(path, CompletableFuture.completedFuture(new Outcome.Read(content)));
    follow(content);
    return content;
  }

  /** Reads a file in a task; the outcome is there, with all that it names, when all have ended. */
  CompletableFuture<Outcome> file(Path path) {
    return files.computeIfAbsent(
        path,
        wanted -> {
          CompletableFuture<Outcome> outcome = new CompletableFuture<>();
          tasks.start(() -> outcome.complete(read(wanted)));
          return outcome;
        });
  }

  private Outcome read(Path path) {
    try (InputStream in = Files.newInputStream(path)) {
      Problems problems = new Problems();
      X3dFile file = reader.read(root.display(path), in, Files.size(path), problems);
      Path folder = path.getParent();
      FileContent content = new FileContent(path, folder == null ? path : folder, file);
      content.problems().addAll(problems.list());
      follow(content);
      return new Outcome.Read(content);
    } catch (IOException e) {
      return new Outcome.Failed(root.display(path) + " " + Failure.clause(e));
    }
  }

  private record InlineFile(ParsedNode inline, Path path, long size) {}

  /** Begins to read what a file names and to make its meshes. */
  void follow(FileContent content) {
    List<InlineFile> inlined = new ArrayList<>();
    List<Runnable> assets = new ArrayList<>();
    NodeWalk.visit(
        content.file().nodes(),
        node -> {
          content.types().add(node.type().name());
          if (node.type().name().equals("Inline") && node.bool("load")) {
            find(node, content, inlined::add);
          } else if (tessellator.handles(node.type())) {
            assets.add(task(content, problems -> mesh(node, content, problems)));
          } else if (node.type().is("X3DTexture2DNode")) {
            assets.add(task(content, problems -> image(node, content, problems)));
          }
        });
    // The largest first: begun last, it would keep everybody waiting.
    inlined.sort(Comparator.comparingLong(InlineFile::size).reversed());
    inlined.forEach(found -> content.inlines().put(found.inline(), file(found.path())));
    assets.forEach(tasks::start);
  }

  private void find(ParsedNode inline, FileContent content, Consumer<InlineFile> found) {
    UrlChoice choice = UrlChoice.of(inline, root, content.folder(), "the Inline is left out");
    if (choice instanceof UrlChoice.File file) {
      long size = file.path().toFile().length();
      found.accept(new InlineFile(inline, file.path(), size));
    } else {
      content.problems().addAll(List.of(((UrlChoice.None) choice).problem()));
    }
  }

  private static Runnable task(FileContent content, Consumer<Problems> work) {
    return () -> {
      Problems problems = new Problems();
      work.accept(problems);
      content.problems().addAll(problems.list());
    };
  }

  private void mesh(ParsedNode geometry, FileContent content, Problems problems) {
    content.meshes().put(geometry, tessellator.tessellate(geometry, problems));
  }

  private void image(ParsedNode texture, FileContent content, Problems problems) {
    content.images().put(texture, images.read(texture, content.folder(), problems));
  }
}
