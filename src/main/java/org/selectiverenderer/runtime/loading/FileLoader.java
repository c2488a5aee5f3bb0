package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.x3d.ContentRoot;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.X3dReader;
import org.selectiverenderer.x3d.geometry.Tessellator;

/**
 * Reads a file and everything it names, all at once on an executor: each file, each geometry and
 * each image is a task of its own. One loader serves one load.
 */
final class FileLoader {
  private final X3dReader reader;
  private final Tessellator tessellator;
  private final Executor executor;
  private final ContentRoot root;
  private final Map<Path, CompletableFuture<Optional<FileContent>>> files =
      new ConcurrentHashMap<>();
  private final ConcurrentLinkedQueue<CompletableFuture<?>> tasks = new ConcurrentLinkedQueue<>();

  FileLoader(X3dReader reader, Tessellator tessellator, Executor executor, ContentRoot root) {
    this.reader = reader;
    this.tessellator = tessellator;
    this.executor = executor;
    this.root = root;
  }

  /**
   * Reads the stream of the first file and all that it names; returns when everything is there.
   *
   * @param name for messages
   * @param path the file, or the folder it counts as being in
   * @param folder against which relative urls are resolved
   */
  FileContent load(String name, InputStream in, Path path, Path folder) throws IOException {
    Problems problems = new Problems();
    FileContent content = new FileContent(path, reader.read(name, in, problems), problems);
    files.put(path, CompletableFuture.completedFuture(Optional.of(content)));
    follow(content, folder, folder);
    for (CompletableFuture<?> task = tasks.poll(); task != null; task = tasks.poll()) {
      task.join();
    }
    return content;
  }

  /** Reads one file that an Inline names and all that it names in turn. */
  Optional<FileContent> loadInline(ParsedNode inline, Path folder, Path nameFolder, Problems to) {
    Optional<FileReference> reference = inline(inline, folder, nameFolder, to);
    for (CompletableFuture<?> task = tasks.poll(); task != null; task = tasks.poll()) {
      task.join();
    }
    return reference.flatMap(FileReference::content);
  }

  /** Named apart so that it reads well. */
  private interface FileReference extends FileContent.FileReference {}

  private void follow(FileContent content, Path folder, Path nameFolder) {
    NodeWalk.visit(
        content.file().nodes(),
        node -> {
          if (node.type().name().equals("Inline") && node.bool("load")) {
            inline(node, folder, nameFolder, content.problems())
                .ifPresent(reference -> content.inlines().put(node, reference));
          } else if (tessellator.handles(node.type())) {
            start(
                () -> content.meshes().put(node, tessellator.tessellate(node, content.problems())));
          } else if (node.type().is("X3DTexture2DNode")) {
            start(() -> content.images().put(node, image(node, folder, content.problems())));
          }
        });
  }

  private void start(Runnable task) {
    tasks.add(CompletableFuture.runAsync(task, executor));
  }

  private Optional<FileReference> inline(
      ParsedNode inline, Path folder, Path nameFolder, Problems problems) {
    return first(inline, folder, problems)
        .map(
            path -> {
              CompletableFuture<Optional<FileContent>> file =
                  files.computeIfAbsent(
                      path,
                      wanted -> begin(() -> read(wanted, nameFolder, inline.location(), problems)));
              return file::join;
            });
  }

  private CompletableFuture<Optional<FileContent>> begin(Supplier<Optional<FileContent>> reading) {
    CompletableFuture<Optional<FileContent>> future =
        CompletableFuture.supplyAsync(reading, executor);
    tasks.add(future);
    return future;
  }

  private Optional<FileContent> read(
      Path path, Path nameFolder, Location requestedBy, Problems requester) {
    String name = displayName(path, nameFolder);
    Problems problems = new Problems();
    try (InputStream in = Files.newInputStream(path)) {
      FileContent content = new FileContent(path, reader.read(name, in, problems), problems);
      Path folder = path.getParent();
      follow(content, folder == null ? path : folder, nameFolder);
      return Optional.of(content);
    } catch (IOException e) {
      requester.error(
          requestedBy, "%s cannot be read and is left out (%s)".formatted(name, reason(e)));
      return Optional.empty();
    }
  }

  /** A file as messages name it: relative to the scene's folder when that is shorter. */
  static String displayName(Path path, Path nameFolder) {
    Path base = nameFolder.toAbsolutePath().normalize();
    try {
      base = base.toRealPath();
    } catch (IOException e) {
      return path.toString();
    }
    if (!java.util.Objects.equals(base.getRoot(), path.getRoot())) {
      return path.toString();
    }
    String relative = nameFolder.resolve(base.relativize(path)).normalize().toString();
    return relative.isEmpty() ? path.toString() : relative;
  }

  /** The first of a node's urls that names a file to be read; says why when none does. */
  private Optional<Path> first(ParsedNode node, Path folder, Problems problems) {
    String[] urls = node.strings("url");
    String reason = null;
    for (String url : urls) {
      ContentRoot.Target target = root.resolve(url, folder);
      if (target instanceof ContentRoot.Target.File file) {
        return Optional.of(file.path());
      }
      if (reason == null && target instanceof ContentRoot.Target.Refused refused) {
        reason = "%s %s".formatted(url, refused.reason());
      }
    }
    problems.error(
        node.location(),
        "%s %s; the %s is left out"
            .formatted(
                node.type().name(),
                reason == null ? "has no url" : "url " + reason,
                node.type().name().equals("Inline") ? "Inline" : "texture"));
    return Optional.empty();
  }

  private Optional<Texture.Image> image(ParsedNode node, Path folder, Problems problems) {
    try {
      return switch (node.type().name()) {
        case "PixelTexture" -> Optional.of(ImageDecoder.pixels(node.ints("image")));
        case "ImageTexture" -> {
          Optional<Path> file = first(node, folder, problems);
          yield file.isEmpty() ? Optional.empty() : Optional.of(ImageDecoder.read(file.get()));
        }
        default -> Optional.empty();
      };
    } catch (IOException e) {
      problems.error(
          node.location(), "%s %s; the texture is left out".formatted(described(node), reason(e)));
      return Optional.empty();
    }
  }

  private static String described(ParsedNode node) {
    return node.type().name().equals("PixelTexture")
        ? "the image of the PixelTexture"
        : String.join(" ", node.strings("url"));
  }

  private static String reason(IOException e) {
    @Nullable String message = e.getMessage();
    return message == null ? e.getClass().getSimpleName() : message;
  }
}
