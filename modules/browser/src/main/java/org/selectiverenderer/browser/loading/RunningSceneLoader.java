package org.selectiverenderer.browser.loading;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.movie.MoviePlayback;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.network.LoadSensorNode;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;
import org.selectiverenderer.browser.nodes.sound.AudioClipNode;
import org.selectiverenderer.browser.nodes.sound.MovieTextureNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.shader.ShaderSource;

/**
 * Loads the files that a scene names while it runs: Inlines whose {@code load} or {@code url}
 * changes (X3D 4.0, 9.4.2), textures and AudioClips with a new url, and Anchors that are followed.
 * The loader's threads read the files, so that no frame waits for a disk. The old content stays
 * until the new content has arrived; the stepping thread then replaces it. If a file cannot be
 * read, a problem is reported and the node is empty.
 *
 * <p>Belongs to the thread that steps the world.
 */
public final class RunningSceneLoader {
  private static final String NOTHING_MADE = "no nodes are created from it";

  private final LoadedScene loaded;
  private final ProblemCollector problems;
  private final Consumer<Map<Mesh, MeshBvh>> built;
  private final FrameBudgetQueue arrivals;
  private final InlineUpdater inlines;
  private final RunningSceneAssets images;
  private final AudioClipUpdater sounds;
  private final MovieTextureUpdater movies;
  private final LoadSensorUpdater loads;

  /**
   * @param problems receives the problems of the files read
   * @param post runs a task on the stepping thread
   * @param built receives the hierarchies of large meshes that arrive, on the stepping thread
   */
  public RunningSceneLoader(
      LoadedScene loaded,
      ProblemCollector problems,
      Consumer<Runnable> post,
      Consumer<Map<Mesh, MeshBvh>> built) {
    this.loaded = loaded;
    this.built = built;
    this.problems = problems;
    arrivals = new FrameBudgetQueue(post);
    inlines = new InlineUpdater(this, new ImportUpdater(loaded.scene(), problems));
    images = new RunningSceneAssets(this, loaded.loader().store().assets());
    sounds = new AudioClipUpdater(this);
    movies = new MovieTextureUpdater(images, problems);
    loads = new LoadSensorUpdater(images);
  }

  /** Returns the assets of the scene's nodes, including those that arrive later. */
  public AssetProvider assets() {
    return images;
  }

  /** Sets the Inlines in the scene; called whenever its structure has changed. */
  public void watch(Collection<InlineNode> present) {
    inlines.watch(present);
  }

  /** Sets the AudioClips played in the scene; called whenever its structure has changed. */
  public void watchClips(Collection<AudioClipNode> present) {
    sounds.watch(present);
  }

  /** Sets the frame-driven nodes of the scene; called whenever its structure has changed. */
  public void watchFrameNodes(List<FrameDrivenNode> present) {
    movies.watch(only(MovieTextureNode.class, present));
    loads.watch(only(LoadSensorNode.class, present));
  }

  private static <T> List<T> only(Class<T> kind, List<FrameDrivenNode> from) {
    return from.stream().filter(kind::isInstance).map(kind::cast).toList();
  }

  /** Makes drawing wait until the due movie frames are decoded. */
  public void waitForFilms() {
    loaded.loader().room().waitForPictures();
  }

  /** Ends a frame: starts to read the files that its events have requested. */
  public void update() {
    arrivals.frame();
    inlines.update();
    sounds.update();
    movies.update();
  }

  /**
   * Reads the scene that an Anchor or a Script links to.
   *
   * @param node the Anchor or Script, which has a field {@code url}; urls are resolved against its
   *     file
   * @param arrived receives the scene on the stepping thread; not called if there is none
   */
  public void open(Node node, String[] urls, Consumer<LoadedScene> arrived) {
    request(
        loaded.loader().late().link(asking(node, urls), origin(node), "the viewer stays here"),
        scene -> arrived.accept(loaded(scene)),
        () -> {});
  }

  /**
   * Reads the scene that the first usable url names, at the request of a node.
   *
   * @param asker the requesting node, which has a field {@code url}; urls are resolved against its
   *     file, and messages name it
   * @param arrived receives the scene on the stepping thread; not called if there is none
   */
  public void read(Node asker, String[] urls, Consumer<LoadedScene> arrived) {
    request(
        loaded.loader().late().link(asking(asker, urls), origin(asker), NOTHING_MADE),
        scene -> arrived.accept(loaded(scene)),
        () -> {});
  }

  /** Reads a scene like {@link #read} but waits for it; empty, with a message, if there is none. */
  public Optional<LoadedScene> readNow(Node asker, String[] urls) {
    AsyncResourceLoader.Arrival<Scene> arrival =
        loaded.loader().late().link(asking(asker, urls), origin(asker), NOTHING_MADE).join();
    arrival.problems().forEach(problems::add);
    return arrival.value().map(this::loaded);
  }

  /**
   * Makes a scene from a text; empty, with a message, if the text holds none.
   *
   * @param asker the requesting node; urls of the scene are resolved against its file, and messages
   *     name it
   */
  public Optional<LoadedScene> text(Node asker, String text) {
    ProblemCollector heard = new ProblemCollector(problems::add);
    String name = asker.location() + " (text)";
    Scene scene = loaded.loader().text(name, text, origin(asker), heard);
    boolean none = scene.root().nodes("children").isEmpty() && heard.any();
    return none ? Optional.empty() : Optional.of(loaded(scene));
  }

  /**
   * Makes an instance of a prototype that a scene declares; empty if it declares none of that name.
   *
   * @return a scene that holds the instance; after a message, a scene without nodes if the
   *     prototype's body has none
   */
  public Optional<Scene> instance(Scene of, String prototype) {
    NodeRegistry store = loaded.loader().store();
    return store
        .prototypes(of.root())
        .filter(library -> library.has(prototype))
        .map(
            library ->
                loaded
                    .loader()
                    .instance(
                        of.url(),
                        library,
                        prototype,
                        origin(of.root()),
                        new ProblemCollector(problems::add)));
  }

  /** Wraps a scene of this loader, to be shown. */
  public LoadedScene loaded(Scene scene) {
    return new LoadedScene(scene, loaded.loader());
  }

  /** Makes a scene of nodes of this loader, to be shown. */
  public LoadedScene loaded(List<?> nodes) {
    Scene from = loaded.scene();
    Node root = loaded.loader().factory().make(from.root().type(), null, from.root().location());
    root.init(root.type().indexOf("children"), List.copyOf(nodes));
    return loaded(
        new Scene(
            root,
            from.url(),
            from.version(),
            from.profile(),
            from.components(),
            from.unitLength()));
  }

  /**
   * Makes a node of a type for a Script; empty if there is no such type.
   *
   * @param asker the Script; urls of the node are resolved against its file
   */
  public Optional<Node> make(Node asker, String type, SourceLocation location) {
    Optional<Node> made = make(type, location);
    made.ifPresent(node -> loaded.loader().store().maker(node, origin(asker)));
    return made;
  }

  /** Returns the catalogue of node types. */
  public NodeCatalogue catalogue() {
    return loaded.loader().catalogue();
  }

  /** Makes a node of a type with all fields at their defaults; empty if there is no such type. */
  public Optional<Node> make(String type, SourceLocation location) {
    return catalogue()
        .find(type)
        .map(found -> loaded.loader().factory().make(found, null, location));
  }

  /** Makes a parsed copy of a node that requests other urls. */
  private ParsedNode asking(Node asker, String[] urls) {
    ParsedNode asking = new ParsedNode(asker.type(), asker.name(), asker.location());
    asking.put(asker.type().indexOf("url"), urls.clone());
    return asking;
  }

  /** Reads the file that an Inline names now. */
  void inline(InlineNode inline, Consumer<Optional<Scene>> arrived) {
    request(inline, loaded.loader().late().inline(copy(inline), origin(inline)), arrived);
  }

  /** Reads the file that a texture names now. */
  void image(Node texture, Consumer<Optional<Texture.Image>> arrived) {
    request(texture, loaded.loader().late().image(copy(texture), origin(texture)), arrived);
  }

  /** Reads the file that an AudioClip names now. */
  void sound(AudioClipNode clip, Consumer<Optional<AudioBuffer>> arrived) {
    request(clip, loaded.loader().late().sound(copy(clip), origin(clip)), arrived);
  }

  /** Reads the source of a shader part as its fields are now. */
  void shader(Node part, Consumer<Optional<ShaderSource>> arrived) {
    ParsedNode asking = copy(part);
    asking.put(part.type().indexOf("sourceCode"), part.string("sourceCode"));
    request(
        loaded.loader().late().shader(asking, origin(part)),
        text -> arrived.accept(Optional.of(text)),
        () -> arrived.accept(Optional.empty()));
  }

  /** Reports a problem that was found while the scene runs. */
  void told(Problem problem) {
    problems.add(problem);
  }

  /** Returns the texture for a side of a Background, with the url that the Background has now. */
  Optional<Node> picture(Node background, Background.Side side) {
    NodeRegistry store = loaded.loader().store();
    Optional<Node> known = store.picture(background, side);
    String[] url = background.strings(side.urlField());
    if (known.isEmpty() && url.length == 0) {
      return known;
    }
    Node texture = known.orElseGet(() -> newPicture(background, side));
    int field = texture.type().indexOf("url");
    if (texture.value(field) != url) {
      texture.init(field, url);
    }
    return Optional.of(texture);
  }

  private Node newPicture(Node background, Background.Side side) {
    SceneLoader loader = loaded.loader();
    Node texture =
        loader.factory().make(loader.catalogue().get("ImageTexture"), null, background.location());
    loader.store().origin(texture, origin(background));
    loader.store().picture(background, side, texture);
    return texture;
  }

  /** Returns whether a node came with a file, so that the files it named then have been read. */
  boolean fromFile(Node node) {
    return loaded.loader().store().origin(node).isPresent();
  }

  /** Returns the metres per unit of length of the file that contains a node. */
  double unitLength(Node node) {
    return origin(node).unitLength();
  }

  /** Reads what a node names and tells LoadSensors about it. */
  private <T> void request(
      Node node,
      CompletableFuture<AsyncResourceLoader.Arrival<T>> reading,
      Consumer<Optional<T>> arrived) {
    loads.begins(node);
    request(
        reading,
        found -> {
          arrived.accept(Optional.of(found));
          loads.ends(node);
        },
        () -> {
          arrived.accept(Optional.empty());
          loads.ends(node);
        });
  }

  private <T> void request(
      CompletableFuture<AsyncResourceLoader.Arrival<T>> reading,
      Consumer<T> arrived,
      Runnable failed) {
    reading.thenAccept(
        arrival ->
            arrivals.add(
                arrival.work(),
                () -> {
                  for (Problem problem : arrival.problems()) {
                    problems.add(problem);
                  }
                  built.accept(arrival.hierarchies());
                  arrival.value().ifPresentOrElse(arrived, failed);
                }));
  }

  /**
   * Returns where the urls of a node start; a node that an application made belongs to the running
   * scene.
   */
  private UrlContext origin(Node node) {
    NodeRegistry store = loaded.loader().store();
    return store
        .origin(node)
        .or(() -> store.maker(node))
        .or(() -> UrlContext.of(loaded.scene()))
        .orElseGet(() -> UrlContext.workingFolder(loaded.loader().access()));
  }

  /** Copies a node's present field values, for other threads. */
  private static ParsedNode copy(Node node) {
    ParsedNode copy = new ParsedNode(node.type(), node.name(), node.location());
    int url = node.type().indexOf("url");
    copy.put(url, ((String[]) node.value(url)).clone());
    return copy;
  }

  /** Follows the MovieTextures of a running scene and reports those whose decoding has failed. */
  private static final class MovieTextureUpdater {
    private final RunningSceneAssets images;
    private final ProblemCollector problems;
    private List<MovieTextureNode> watched = List.of();

    MovieTextureUpdater(RunningSceneAssets images, ProblemCollector problems) {
      this.images = images;
      this.problems = problems;
    }

    void watch(List<MovieTextureNode> present) {
      watched = present;
    }

    void update() {
      for (MovieTextureNode movie : watched) {
        images.image(movie); // A texture that a script has made starts before it is drawn.
        movie.film().ifPresent(film -> follow(movie, film));
      }
    }

    private void follow(MovieTextureNode movie, MoviePlayback film) {
      film.nextFrame();
      film.fault()
          .ifPresent(
              clause ->
                  problems.error(
                      movie.location(),
                      "the file of the MovieTexture %s; its last picture stays".formatted(clause)));
    }
  }
}
