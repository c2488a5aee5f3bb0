package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinWorkerThread;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.joml.FrustumIntersection;
import org.joml.Matrix4d;
import org.joml.Matrix4f;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.geometry.tessellate.Tessellator;
import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.loading.FileContent.Outcome;
import org.selectiverenderer.runtime.movie.ProjectionRoom;
import org.selectiverenderer.runtime.nodes.NodeFactory;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.runtime.sound.Recording;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentAccess;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.PrototypeLibrary;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.shader.ShaderText;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * Loads scenes. Owns as many threads as there are processors, named {@code scene-loader-N}, until
 * it is closed, and those that decode films. All scenes of one loader share their assets, so that
 * nodes of one may be put into another. Thread-safe.
 */
public final class SceneLoader implements AutoCloseable {
  private final NodeCatalogue catalogue;
  private final NodeFactory factory;
  private final X3dReader reader;
  private final Tessellator tessellator = new Tessellator();
  private final ContentAccess access;
  private final Problems problems;
  private final SceneStore store;
  private final ProjectionRoom room = new ProjectionRoom();
  private final int maxNodes;
  private final ForkJoinPool threads;

  /** A loader of scenes that may name no more than their own files and those of their project. */
  public SceneLoader(
      NodeCatalogue catalogue, NodeFactory factory, ReadLimits limits, Problems problems) {
    this(catalogue, factory, limits, ContentAccess.none(), problems);
  }

  /**
   * @param limits of each file; the limit of nodes also holds for a scene with all its Inlines
   * @param access what scenes may name besides their own files
   * @param problems hears what is wrong with the files read
   */
  public SceneLoader(
      NodeCatalogue catalogue,
      NodeFactory factory,
      ReadLimits limits,
      ContentAccess access,
      Problems problems) {
    this.access = access;
    this.catalogue = catalogue;
    this.factory = factory;
    this.problems = problems;
    reader = new X3dReader(catalogue, limits);
    maxNodes = limits.maxNodes();
    AssetStore assets =
        new AssetStore(
            node -> tessellator.tessellate(node, problems),
            node -> ImageFiles.pixels(node, problems),
            problems);
    store = new SceneStore(assets, factory::actsOn);
    threads = threads();
    threads.execute(SceneLoader::loadMatrices);
  }

  /**
   * Loads JOML's classes while the first file is read. They are of an old format, which class-data
   * sharing passes over, so that it takes some 20 ms, which the world would otherwise wait for.
   */
  private static void loadMatrices() {
    Matrix4d matrix = new Matrix4d().translationRotate(new Vector3d(), new Quaterniond());
    new FrustumIntersection(new Matrix4f(matrix));
  }

  /**
   * A thread works on what it has itself begun last, the geometry of the file just read, before it
   * takes from others what those began first, the largest files: what is in the cache is finished,
   * and what takes long is begun early.
   */
  private static ForkJoinPool threads() {
    AtomicInteger count = new AtomicInteger();
    return new ForkJoinPool(
        Runtime.getRuntime().availableProcessors(),
        pool -> {
          ForkJoinWorkerThread thread =
              ForkJoinPool.defaultForkJoinWorkerThreadFactory.newThread(pool);
          thread.setName("scene-loader-" + count.incrementAndGet());
          return thread;
        },
        null,
        false);
  }

  /** The meshes and images of all scenes of this loader. */
  public Assets assets() {
    return store.assets();
  }

  public NodeCatalogue catalogue() {
    return catalogue;
  }

  public NodeFactory factory() {
    return factory;
  }

  /**
   * Reads a scene and everything it inlines.
   *
   * @throws IOException with a one-line message when the file itself cannot be read
   */
  public LoadedScene load(Path file) throws IOException {
    return load(file, problems);
  }

  /**
   * As {@link #load(Path)}.
   *
   * @param hears hears what is wrong with this scene, in place of the loader's own
   */
  public LoadedScene load(Path file, Problems hears) throws IOException {
    if (Files.isDirectory(file)) {
      throw new IOException(file + " is a folder, not a scene");
    }
    Path parent = file.getParent();
    Path folder = parent == null ? Path.of("") : parent;
    try (InputStream in = Files.newInputStream(file)) {
      return load(
          file.toString(),
          in,
          Files.size(file),
          file.toRealPath().toString(),
          folder,
          ContentBase.folder(folder),
          hears);
    }
  }

  /**
   * Reads a scene from a stream.
   *
   * @param name for messages
   * @param folder against which its urls are resolved
   */
  public LoadedScene load(String name, InputStream in, Path folder) throws IOException {
    return load(name, in, folder, problems);
  }

  /**
   * As {@link #load(String, InputStream, Path)}.
   *
   * @param hears hears what is wrong with this scene, in place of the loader's own
   */
  public LoadedScene load(String name, InputStream in, Path folder, Problems hears)
      throws IOException {
    return load(name, in, 0, folder.toString(), folder, ContentBase.folder(folder), hears);
  }

  /**
   * As {@link #load(String, InputStream, Path)}.
   *
   * @param base against which its urls are resolved: a folder, or an address of the network
   * @param hears hears what is wrong with this scene, in place of the loader's own
   */
  public LoadedScene load(String name, InputStream in, ContentBase base, Problems hears)
      throws IOException {
    Path folder = base instanceof ContentBase.Folder of ? of.path() : Path.of("");
    return load(name, in, 0, base.toString(), folder, base, hears);
  }

  /**
   * Reads a scene of the network, as far as that is allowed, or of a {@code data:} url.
   *
   * @param hears hears what is wrong with this scene, in place of the loader's own
   * @throws IOException with a one-line message when it may not or cannot be read
   */
  public LoadedScene load(String url, Problems hears) throws IOException {
    Path here = Path.of("");
    ContentRoot.Target target = new ContentRoot(here, access).resolve(url, here);
    if (target instanceof ContentRoot.Target.Refused refused) {
      throw new IOException("url '%s' %s".formatted(UrlChoice.shown(url), refused.reason()));
    }
    Content content = ((ContentRoot.Target.Found) target).content();
    try (InputStream in = content.open()) {
      return load(content.name(), in, content.size(), content.key(), here, content.base(), hears);
    }
  }

  private LoadedScene load(
      String name,
      InputStream in,
      long size,
      String key,
      Path folder,
      ContentBase base,
      Problems hears)
      throws IOException {
    ContentRoot root = new ContentRoot(folder, access);
    TaskGroup tasks = new TaskGroup(threads);
    FileContent content =
        new FileLoader(reader, tessellator, tasks, root, room).first(name, in, size, key, base);
    TaskGroup.await(tasks.end());
    return new LoadedScene(build(content, root, List.of(), hears), this);
  }

  /**
   * Makes a scene of a text, which may name what the scene that it comes from may.
   *
   * @param name for messages
   */
  Scene text(String name, String text, UrlBase origin, Problems hears) {
    String whole = SceneText.whole(text);
    return made(loader -> loader.parts(name, whole, origin.file(), origin.base()), origin, hears);
  }

  /**
   * Makes a scene of one instance of a prototype.
   *
   * @param name for messages
   * @param origin of the scene that declares the prototype
   */
  Scene instance(
      String name, PrototypeLibrary library, String prototype, UrlBase origin, Problems hears) {
    return made(
        loader -> loader.instance(name, library, prototype, origin.file(), origin.base()),
        origin,
        hears);
  }

  private Scene made(Function<FileLoader, FileContent> reading, UrlBase origin, Problems hears) {
    TaskGroup tasks = new TaskGroup(threads);
    FileContent content =
        reading.apply(new FileLoader(reader, tessellator, tasks, origin.root(), room));
    TaskGroup.await(tasks.end());
    return build(content, origin.root(), origin.above(), hears);
  }

  private Scene build(FileContent content, ContentRoot root, List<String> above, Problems hears) {
    SceneBuilder builder =
        new SceneBuilder(
            factory, catalogue.get("Group"), catalogue.get("Inline"), store, root, maxNodes);
    Scene scene = builder.build(content, above);
    builder.report(hears);
    return scene;
  }

  /** What scenes may name besides their own files. */
  public ContentAccess access() {
    return access;
  }

  /** Where the films of its scenes are decoded. */
  public ProjectionRoom room() {
    return room;
  }

  SceneStore store() {
    return store;
  }

  /**
   * What has been read in the background.
   *
   * @param value empty when it could not be read
   * @param problems with it, in order
   * @param work that it makes where it is shown, in triangles
   */
  record Arrival<T>(Optional<T> value, List<Problem> problems, long work) {}

  /** Reads the file that an Inline names and all that it names in turn. */
  CompletableFuture<Arrival<Scene>> inline(ParsedNode inline, UrlBase origin) {
    return read(
        inline,
        origin,
        (content, hears) -> {
          Scene holder = build(content, origin.root(), origin.above(), hears);
          return ((InlineNode) holder.root().nodes("children").get(0)).content();
        });
  }

  /** Reads the image that an ImageTexture names. */
  CompletableFuture<Arrival<Texture.Image>> image(ParsedNode texture, UrlBase origin) {
    return read(
        texture,
        origin,
        (content, hears) -> {
          content.problems().list().forEach(hears::add);
          return content.images().getOrDefault(texture, Optional.empty());
        });
  }

  /** Reads the text of a part of a shader. */
  CompletableFuture<Arrival<ShaderText>> shader(ParsedNode part, UrlBase origin) {
    return read(
        part,
        origin,
        (content, hears) -> {
          content.problems().list().forEach(hears::add);
          return content.shaders().getOrDefault(part, Optional.empty());
        });
  }

  /** Reads the sound that an AudioClip names. */
  CompletableFuture<Arrival<Recording>> sound(ParsedNode clip, UrlBase origin) {
    return read(
        clip,
        origin,
        (content, hears) -> {
          content.problems().list().forEach(hears::add);
          return Optional.ofNullable(content.sounds().get(clip));
        });
  }

  /** What is made of the files read. */
  @FunctionalInterface
  private interface Making<T> {
    Optional<T> make(FileContent content, Problems hears);
  }

  /** Reads what a node names, as if it were the only one of its file. */
  private <T> CompletableFuture<Arrival<T>> read(
      ParsedNode node, UrlBase origin, Making<T> making) {
    TaskGroup tasks = new TaskGroup(threads);
    FileLoader loader = new FileLoader(reader, tessellator, tasks, origin.root(), room);
    FileContent content =
        new FileContent(origin.file(), origin.base(), X3dFile.of(node, origin.unitLength()));
    tasks.start(() -> loader.follow(content));
    return arrival(tasks, node, hears -> making.make(content, hears), content::work);
  }

  /**
   * Reads the scene that an Anchor links to, or that another node asks for; it may name what the
   * scene with that node may.
   *
   * @param consequence what is done when there is none
   */
  CompletableFuture<Arrival<Scene>> link(ParsedNode anchor, UrlBase origin, String consequence) {
    TaskGroup tasks = new TaskGroup(threads);
    FileLoader loader = new FileLoader(reader, tessellator, tasks, origin.root(), room);
    AtomicReference<Function<Problems, Optional<Scene>>> making =
        new AtomicReference<>(hears -> Optional.empty());
    tasks.start(
        () -> {
          UrlChoice choice = UrlChoice.of(anchor, origin.root(), origin.base(), consequence);
          if (choice instanceof UrlChoice.Found file) {
            CompletableFuture<Outcome> outcome = loader.file(file.content());
            making.set(hears -> scene(outcome.join(), anchor, origin.root(), consequence, hears));
          } else {
            making.set(
                hears -> {
                  hears.add(((UrlChoice.None) choice).problem());
                  return Optional.empty();
                });
          }
        });
    return arrival(tasks, anchor, hears -> making.get().apply(hears), () -> 0);
  }

  private Optional<Scene> scene(
      Outcome outcome, ParsedNode anchor, ContentRoot root, String consequence, Problems hears) {
    if (outcome instanceof Outcome.Read read) {
      return Optional.of(build(read.content(), root, List.of(), hears));
    }
    hears.error(anchor.location(), ((Outcome.Failed) outcome).sentence() + "; " + consequence);
    return Optional.empty();
  }

  private <T> CompletableFuture<Arrival<T>> arrival(
      TaskGroup tasks, ParsedNode node, Function<Problems, Optional<T>> making, LongSupplier work) {
    return tasks
        .end()
        .thenApplyAsync(
            over -> {
              Problems hears = new Problems();
              Optional<T> made = making.apply(hears);
              return new Arrival<>(made, hears.list(), work.getAsLong());
            },
            threads)
        .exceptionally(
            failure -> {
              Throwable cause = failure.getCause() == null ? failure : failure.getCause();
              Problem problem =
                  new Problem(
                      Problem.Severity.ERROR,
                      node.location(),
                      "what the %s names could not be read (%s); it is left out"
                          .formatted(node.type().name(), cause));
              return new Arrival<>(Optional.empty(), List.of(problem), 0);
            });
  }

  @Override
  public void close() {
    room.close();
    threads.shutdown();
  }
}
