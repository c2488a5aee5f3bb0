package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinWorkerThread;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.function.Supplier;
import org.joml.FrustumIntersection;
import org.joml.Matrix4d;
import org.joml.Matrix4f;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.geometry.tessellate.Tessellator;
import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.movie.ProjectionRoom;
import org.selectiverenderer.runtime.nodes.NodeFactory;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentAccess;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;
import org.selectiverenderer.x3d.read.PrototypeLibrary;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * Loads scenes. Until it is closed it owns as many threads as there are processors, named {@code
 * scene-loader-N}, and the threads that decode movies. All scenes of one loader share their assets,
 * so that nodes of one scene may be put into another. Thread-safe.
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
  private final LateReading late = new LateReading(this);

  /** Makes a loader of scenes that may only name files in their own folder and their project. */
  public SceneLoader(
      NodeCatalogue catalogue, NodeFactory factory, ReadLimits limits, Problems problems) {
    this(catalogue, factory, limits, ContentAccess.none(), problems);
  }

  /**
   * @param limits the limits for each file; the limit of nodes also holds for a scene with all its
   *     Inlines
   * @param access the files and addresses that scenes may name besides their own files
   * @param problems receives the problems of the files read
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
   * Loads JOML's classes while the first file is being read. Their old class-file format is
   * excluded from class-data sharing, so that loading takes about 20 ms, for which the world would
   * otherwise wait.
   */
  private static void loadMatrices() {
    Matrix4d matrix = new Matrix4d().translationRotate(new Vector3d(), new Quaterniond());
    new FrustumIntersection(new Matrix4f(matrix));
  }

  /**
   * Makes the thread pool. A thread first works on the task that it has itself begun last, the
   * geometry of the file just read, whose data are in the cache; then it steals from others the
   * tasks begun first, the largest files, so that long tasks begin early.
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

  /** Returns the assets of all scenes of this loader. */
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
   * @throws IOException with a one-line message if the file itself cannot be read
   */
  public LoadedScene load(Path file) throws IOException {
    return load(file, problems);
  }

  /**
   * Reads a scene like {@link #load(Path)}.
   *
   * @param hears receives the problems of this scene, in place of the loader's own
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
   * @param name the scene's name, for messages
   * @param folder the folder against which its urls are resolved
   */
  public LoadedScene load(String name, InputStream in, Path folder) throws IOException {
    return load(name, in, folder, problems);
  }

  /**
   * Reads a scene like {@link #load(String, InputStream, Path)}.
   *
   * @param hears receives the problems of this scene, in place of the loader's own
   */
  public LoadedScene load(String name, InputStream in, Path folder, Problems hears)
      throws IOException {
    return load(name, in, 0, folder.toString(), folder, ContentBase.folder(folder), hears);
  }

  /**
   * Reads a scene like {@link #load(String, InputStream, Path)}.
   *
   * @param base the folder or network address against which its urls are resolved
   * @param hears receives the problems of this scene, in place of the loader's own
   */
  public LoadedScene load(String name, InputStream in, ContentBase base, Problems hears)
      throws IOException {
    Path folder = base instanceof ContentBase.Folder of ? of.path() : Path.of("");
    return load(name, in, 0, base.toString(), folder, base, hears);
  }

  /**
   * Reads a scene from the network, if that is allowed, or from a {@code data:} url.
   *
   * @param hears receives the problems of this scene, in place of the loader's own
   * @throws IOException with a one-line message if the scene may not or cannot be read
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
    TaskGroup tasks = tasks();
    FileContent content = reading(tasks, root).first(name, in, size, key, base);
    TaskGroup.await(tasks.end());
    return new LoadedScene(build(content, root, List.of(), hears), this);
  }

  /**
   * Makes a scene from a text; it may name the same files as the scene from which the text comes.
   *
   * @param name the scene's name, for messages
   */
  Scene text(String name, String text, UrlBase origin, Problems hears) {
    String whole = SceneText.whole(text);
    return made(loader -> loader.parts(name, whole, origin.file(), origin.base()), origin, hears);
  }

  /**
   * Makes a scene that holds one instance of a prototype.
   *
   * @param name the scene's name, for messages
   * @param origin where the urls of the scene start that declares the prototype
   */
  Scene instance(
      String name, PrototypeLibrary library, String prototype, UrlBase origin, Problems hears) {
    return made(
        loader -> loader.instance(name, library, prototype, origin.file(), origin.base()),
        origin,
        hears);
  }

  private Scene made(Function<FileLoader, FileContent> reading, UrlBase origin, Problems hears) {
    TaskGroup tasks = tasks();
    FileContent content = reading.apply(reading(tasks, origin.root()));
    TaskGroup.await(tasks.end());
    return build(content, origin.root(), origin.above(), hears);
  }

  /**
   * Makes a scene from a file that has been read.
   *
   * @param above the keys of the files that inline it, outermost first
   */
  Scene build(FileContent content, ContentRoot root, List<String> above, Problems hears) {
    SceneBuilder builder =
        new SceneBuilder(
            factory, catalogue.get("Group"), catalogue.get("Inline"), store, root, maxNodes);
    Scene scene = builder.build(content, above);
    builder.report(hears);
    return scene;
  }

  /** Makes a loader of a file and everything it names, as one group of tasks. */
  FileLoader reading(TaskGroup tasks, ContentRoot root) {
    return new FileLoader(reader, tessellator, tasks, root, room);
  }

  /** Makes a group of tasks on the loader's threads. */
  TaskGroup tasks() {
    return new TaskGroup(threads);
  }

  /** Runs a function on one of the loader's threads once the tasks have ended. */
  <T> CompletableFuture<T> after(TaskGroup tasks, Supplier<T> work) {
    return tasks.end().thenApplyAsync(over -> work.get(), threads);
  }

  /** Returns the loader of files that running scenes name. */
  LateReading late() {
    return late;
  }

  /** Returns the files and addresses that scenes may name besides their own files. */
  public ContentAccess access() {
    return access;
  }

  /** Returns the threads that decode the movies of this loader's scenes. */
  public ProjectionRoom room() {
    return room;
  }

  SceneStore store() {
    return store;
  }

  @Override
  public void close() {
    room.close();
    threads.shutdown();
  }
}
