package org.selectiverenderer.browser.loading;

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
import java.util.regex.Pattern;
import org.joml.FrustumIntersection;
import org.joml.Matrix4d;
import org.joml.Matrix4f;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.movie.MovieDecoderPool;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.PrototypeLibrary;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.tessellate.Tessellator;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

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
  private final ContentAccessPolicy access;
  private final ProblemCollector problems;
  private final NodeRegistry store;
  private final MovieDecoderPool room = new MovieDecoderPool();
  private final int maxNodes;
  private final ForkJoinPool threads;
  private final AsyncResourceLoader late = new AsyncResourceLoader(this);

  /** Makes a loader of scenes that may only name files in their own folder and their project. */
  public SceneLoader(
      NodeCatalogue catalogue, NodeFactory factory, ReadLimits limits, ProblemCollector problems) {
    this(catalogue, factory, limits, ContentAccessPolicy.none(), problems);
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
      ContentAccessPolicy access,
      ProblemCollector problems) {
    this.access = access;
    this.catalogue = catalogue;
    this.factory = factory;
    this.problems = problems;
    reader = new X3dReader(catalogue, limits);
    maxNodes = limits.maxSceneNodes();
    AssetStore assets =
        new AssetStore(
            node -> tessellator.tessellate(node, problems),
            node -> ImageLoader.pixels(node, problems),
            problems);
    store = new NodeRegistry(assets, factory::actsOn);
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
  public AssetProvider assets() {
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
  public LoadedScene load(Path file, ProblemCollector hears) throws IOException {
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
          BaseUrl.folder(folder),
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
  public LoadedScene load(String name, InputStream in, Path folder, ProblemCollector hears)
      throws IOException {
    return load(name, in, 0, folder.toString(), folder, BaseUrl.folder(folder), hears);
  }

  /**
   * Reads a scene like {@link #load(String, InputStream, Path)}.
   *
   * @param base the folder or network address against which its urls are resolved
   * @param hears receives the problems of this scene, in place of the loader's own
   */
  public LoadedScene load(String name, InputStream in, BaseUrl base, ProblemCollector hears)
      throws IOException {
    Path folder = base instanceof BaseUrl.Folder of ? of.path() : Path.of("");
    return load(name, in, 0, base.toString(), folder, base, hears);
  }

  /**
   * Reads a scene from the network, if that is allowed, or from a {@code data:} url.
   *
   * @param hears receives the problems of this scene, in place of the loader's own
   * @throws IOException with a one-line message if the scene may not or cannot be read
   */
  public LoadedScene load(String url, ProblemCollector hears) throws IOException {
    Path here = Path.of("");
    UrlResolver.Target target = new UrlResolver(here, access).resolve(url, here);
    if (target instanceof UrlResolver.Target.Refused refused) {
      throw new IOException(
          "url '%s' %s".formatted(ResolvedUrlContent.shown(url), refused.reason()));
    }
    UrlContent content = ((UrlResolver.Target.Found) target).content();
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
      BaseUrl base,
      ProblemCollector hears)
      throws IOException {
    UrlResolver root = new UrlResolver(folder, access);
    TaskGroup tasks = tasks();
    LoadedFile content = reading(tasks, root).first(name, in, size, key, base);
    TaskGroup.await(tasks.end());
    return new LoadedScene(build(content, root, List.of(), hears), this);
  }

  /**
   * Makes a scene from a text; it may name the same files as the scene from which the text comes.
   *
   * @param name the scene's name, for messages
   */
  Scene text(String name, String text, UrlContext origin, ProblemCollector hears) {
    String whole = HeaderlessText.whole(text);
    return made(loader -> loader.parts(name, whole, origin.file(), origin.base()), origin, hears);
  }

  /**
   * Makes a scene that holds one instance of a prototype.
   *
   * @param name the scene's name, for messages
   * @param origin where the urls of the scene start that declares the prototype
   */
  Scene instance(
      String name,
      PrototypeLibrary library,
      String prototype,
      UrlContext origin,
      ProblemCollector hears) {
    return made(
        loader -> loader.instance(name, library, prototype, origin.file(), origin.base()),
        origin,
        hears);
  }

  private Scene made(
      Function<SceneFileLoader, LoadedFile> reading, UrlContext origin, ProblemCollector hears) {
    TaskGroup tasks = tasks();
    LoadedFile content = reading.apply(reading(tasks, origin.root()));
    TaskGroup.await(tasks.end());
    return build(content, origin.root(), origin.above(), hears);
  }

  /**
   * Makes a scene from a file that has been read.
   *
   * @param above the keys of the files that inline it, outermost first
   */
  Scene build(LoadedFile content, UrlResolver root, List<String> above, ProblemCollector hears) {
    SceneBuilder builder =
        new SceneBuilder(
            factory, catalogue.get("Group"), catalogue.get("Inline"), store, root, maxNodes);
    Scene scene = builder.build(content, above);
    builder.report(hears);
    return scene;
  }

  /** Makes a loader of a file and everything it names, as one group of tasks. */
  SceneFileLoader reading(TaskGroup tasks, UrlResolver root) {
    return new SceneFileLoader(reader, tessellator, tasks, root, room);
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
  AsyncResourceLoader late() {
    return late;
  }

  /** Returns the files and addresses that scenes may name besides their own files. */
  public ContentAccessPolicy access() {
    return access;
  }

  /** Returns the threads that decode the movies of this loader's scenes. */
  public MovieDecoderPool room() {
    return room;
  }

  NodeRegistry store() {
    return store;
  }

  @Override
  public void close() {
    room.close();
    threads.shutdown();
  }

  /**
   * Completes scene texts that lack a file header: createVrmlFromString takes nodes without the
   * header (VRML97, 4.12.10.7), and many applications leave it out of XML, too.
   */
  private static final class HeaderlessText {
    private static final Pattern WHOLE =
        Pattern.compile("\\A\\s*(?:#|\\{|<\\?|<!|<X3D\\b)", Pattern.CASE_INSENSITIVE);
    private static final Pattern ELEMENT = Pattern.compile("\\A\\s*<");

    private HeaderlessText() {}

    /** Returns the text, with a header added if it has none. */
    static String whole(String text) {
      if (WHOLE.matcher(text).lookingAt()) {
        return text;
      }
      return ELEMENT.matcher(text).lookingAt()
          ? "<X3D version='4.0' profile='Full'><Scene>" + text + "</Scene></X3D>"
          : "#VRML V2.0 utf8\n" + text;
    }
  }
}
