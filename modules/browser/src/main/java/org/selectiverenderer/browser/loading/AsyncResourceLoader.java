package org.selectiverenderer.browser.loading;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.loading.LoadedFile.Outcome;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.shader.ShaderSource;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Reads the files that nodes of a running scene name, asynchronously on the loader's threads; the
 * stepping thread takes over the results.
 */
final class AsyncResourceLoader {
  private final SceneLoader loader;

  AsyncResourceLoader(SceneLoader loader) {
    this.loader = loader;
  }

  /**
   * The result of an asynchronous read.
   *
   * @param value the content; empty if it could not be read
   * @param problems the problems found, in order
   * @param work the cost of showing the content, in triangles
   * @param hierarchies those of its large meshes
   */
  record Arrival<T>(
      Optional<T> value, List<Problem> problems, long work, Map<Mesh, MeshBvh> hierarchies) {}

  /** Reads the file that an Inline names and all files that it names in turn. */
  CompletableFuture<Arrival<Scene>> inline(ParsedNode inline, UrlContext origin) {
    return read(
        inline,
        origin,
        (content, hears) -> {
          Scene holder = loader.build(content, origin.root(), origin.above(), hears);
          return ((InlineNode) holder.root().nodes("children").get(0)).content();
        });
  }

  /** Reads the image that an ImageTexture names. */
  CompletableFuture<Arrival<Texture.Image>> image(ParsedNode texture, UrlContext origin) {
    return read(
        texture,
        origin,
        (content, hears) -> {
          content.problems().list().forEach(hears::add);
          return content.images().getOrDefault(texture, Optional.empty());
        });
  }

  /** Reads the source of a shader part. */
  CompletableFuture<Arrival<ShaderSource>> shader(ParsedNode part, UrlContext origin) {
    return read(
        part,
        origin,
        (content, hears) -> {
          content.problems().list().forEach(hears::add);
          return content.shaders().getOrDefault(part, Optional.empty());
        });
  }

  /** Reads the sound that an AudioClip names. */
  CompletableFuture<Arrival<AudioBuffer>> sound(ParsedNode clip, UrlContext origin) {
    return read(
        clip,
        origin,
        (content, hears) -> {
          content.problems().list().forEach(hears::add);
          return Optional.ofNullable(content.sounds().get(clip));
        });
  }

  /** Makes the result from the files read. */
  @FunctionalInterface
  private interface Making<T> {
    Optional<T> make(LoadedFile content, ProblemCollector hears);
  }

  /** Reads what a node names, as if it were the only node of its file. */
  private <T> CompletableFuture<Arrival<T>> read(
      ParsedNode node, UrlContext origin, Making<T> making) {
    TaskGroup tasks = loader.tasks();
    SceneFileLoader reading = loader.reading(tasks, origin.root());
    LoadedFile content =
        new LoadedFile(origin.file(), origin.base(), X3dFile.of(node, origin.unitLength()));
    tasks.start(() -> reading.follow(content));
    return arrival(
        tasks, node, hears -> making.make(content, hears), content::work, content::hierarchies);
  }

  /**
   * Reads the scene that an Anchor links to or that another node requests. That scene may name the
   * same files as the scene of the node.
   *
   * @param consequence the end of the message if there is none
   */
  CompletableFuture<Arrival<Scene>> link(ParsedNode anchor, UrlContext origin, String consequence) {
    TaskGroup tasks = loader.tasks();
    SceneFileLoader reading = loader.reading(tasks, origin.root());
    AtomicReference<Function<ProblemCollector, Optional<Scene>>> making =
        new AtomicReference<>(hears -> Optional.empty());
    tasks.start(
        () -> {
          ResolvedUrlContent choice =
              ResolvedUrlContent.of(anchor, origin.root(), origin.base(), consequence);
          if (choice instanceof ResolvedUrlContent.Found file) {
            CompletableFuture<Outcome> outcome = reading.file(file.content());
            making.set(hears -> scene(outcome.join(), anchor, origin.root(), consequence, hears));
          } else {
            making.set(
                hears -> {
                  hears.add(((ResolvedUrlContent.None) choice).problem());
                  return Optional.empty();
                });
          }
        });
    return arrival(tasks, anchor, hears -> making.get().apply(hears), () -> 0, Map::of);
  }

  private Optional<Scene> scene(
      Outcome outcome,
      ParsedNode anchor,
      UrlResolver root,
      String consequence,
      ProblemCollector hears) {
    if (outcome instanceof Outcome.Read read) {
      return Optional.of(loader.build(read.content(), root, List.of(), hears));
    }
    hears.error(anchor.location(), ((Outcome.Failed) outcome).sentence() + "; " + consequence);
    return Optional.empty();
  }

  private <T> CompletableFuture<Arrival<T>> arrival(
      TaskGroup tasks,
      ParsedNode node,
      Function<ProblemCollector, Optional<T>> making,
      LongSupplier work,
      Supplier<Map<Mesh, MeshBvh>> hierarchies) {
    return loader
        .after(
            tasks,
            () -> {
              ProblemCollector hears = new ProblemCollector();
              Optional<T> made = making.apply(hears);
              return new Arrival<>(made, hears.list(), work.getAsLong(), hierarchies.get());
            })
        .exceptionally(
            failure -> {
              Throwable cause = failure.getCause() == null ? failure : failure.getCause();
              Problem problem =
                  new Problem(
                      Problem.Severity.ERROR,
                      node.location(),
                      "the file that the %s names could not be read (%s); it is left out"
                          .formatted(node.type().name(), cause));
              return new Arrival<>(Optional.empty(), List.of(problem), 0, Map.of());
            });
  }
}
