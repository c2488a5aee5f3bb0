package org.selectiverenderer.runtime.loading;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.nodes.network.LoadSensorNode;
import org.selectiverenderer.runtime.nodes.sensor.FrameNode;
import org.selectiverenderer.runtime.nodes.sound.AudioClipNode;
import org.selectiverenderer.runtime.nodes.sound.MovieTextureNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.runtime.sound.Recording;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.shader.ShaderText;

/**
 * The files that a running scene comes to name: Inlines whose {@code load} or {@code url} changes
 * (X3D 4.0, 9.4.2), textures and AudioClips with another url, Anchors that are followed. All are
 * read on the loader's threads; what was there stays until the new is there, and takes its place on
 * the stepping thread. No frame waits for a disk. When something cannot be read, that is a problem,
 * and the node is empty.
 *
 * <p>Belongs to the thread that steps the world.
 */
public final class LiveFiles {
  private static final String NOTHING_MADE = "no nodes are made of it";

  private final LoadedScene loaded;
  private final Problems problems;
  private final Arrivals arrivals;
  private final LiveInlines inlines;
  private final LiveImages images;
  private final LiveSounds sounds;
  private final LiveMovies movies;
  private final LiveLoads loads;

  /**
   * @param problems hears what is wrong with the files read
   * @param post runs a task on the stepping thread
   */
  public LiveFiles(LoadedScene loaded, Problems problems, Consumer<Runnable> post) {
    this.loaded = loaded;
    this.problems = problems;
    arrivals = new Arrivals(post);
    inlines = new LiveInlines(this, new LiveImports(loaded.scene(), problems));
    images = new LiveImages(this, loaded.loader().store().assets());
    sounds = new LiveSounds(this);
    movies = new LiveMovies(images, problems);
    loads = new LiveLoads(images);
  }

  /** The meshes and images of the scene's nodes, those that arrive later too. */
  public Assets assets() {
    return images;
  }

  /** Tells which Inlines are in the scene, whenever its structure has changed. */
  public void watch(Collection<InlineNode> present) {
    inlines.watch(present);
  }

  /** Tells which AudioClips are played in the scene, whenever its structure has changed. */
  public void watchClips(Collection<AudioClipNode> present) {
    sounds.watch(present);
  }

  /** Tells which nodes look at frames, whenever the scene's structure has changed. */
  public void watchFrameNodes(List<FrameNode> present) {
    movies.watch(only(MovieTextureNode.class, present));
    loads.watch(only(LoadSensorNode.class, present));
  }

  private static <T> List<T> only(Class<T> kind, List<FrameNode> from) {
    return from.stream().filter(kind::isInstance).map(kind::cast).toList();
  }

  /** Has whoever draws wait for the pictures of films. */
  public void waitForFilms() {
    loaded.loader().room().waitForPictures();
  }

  /** Ends a frame: begins to read what its events have asked for. */
  public void update() {
    arrivals.frame();
    inlines.update();
    sounds.update();
    movies.update();
  }

  /**
   * Reads the scene that an Anchor links to, or a Script that does as Anchors do.
   *
   * @param node has a field {@code url} of its own; against whose file urls are resolved
   * @param arrived takes the scene on the stepping thread; not called when there is none
   */
  public void open(Node node, String[] urls, Consumer<LoadedScene> arrived) {
    request(
        loaded.loader().late().link(asking(node, urls), origin(node), "the viewer stays here"),
        scene -> arrived.accept(loaded(scene)),
        () -> {});
  }

  /**
   * Reads the scene that one of some urls names, for a node that asks for it.
   *
   * @param asker has a field {@code url} of its own; against whose file urls are resolved, and
   *     which messages name
   * @param arrived takes the scene on the stepping thread; not called when there is none
   */
  public void read(Node asker, String[] urls, Consumer<LoadedScene> arrived) {
    request(
        loaded.loader().late().link(asking(asker, urls), origin(asker), NOTHING_MADE),
        scene -> arrived.accept(loaded(scene)),
        () -> {});
  }

  /** The same at once: waits for the file. Empty, with a message, when there is no scene. */
  public Optional<LoadedScene> readNow(Node asker, String[] urls) {
    LateReading.Arrival<Scene> arrival =
        loaded.loader().late().link(asking(asker, urls), origin(asker), NOTHING_MADE).join();
    arrival.problems().forEach(problems::add);
    return arrival.value().map(this::loaded);
  }

  /**
   * Makes a scene of a text; empty, with a message, when it holds none.
   *
   * @param asker against whose file urls of the scene are resolved, and which messages name
   */
  public Optional<LoadedScene> text(Node asker, String text) {
    Problems heard = new Problems(problems::add);
    String name = asker.location() + " (text)";
    Scene scene = loaded.loader().text(name, text, origin(asker), heard);
    boolean none = scene.root().nodes("children").isEmpty() && heard.any();
    return none ? Optional.empty() : Optional.of(loaded(scene));
  }

  /**
   * Makes an instance of a prototype that a scene declares; empty if it declares none of the name.
   *
   * @return a scene that holds the instance; without a node, after a message, where the body has
   *     none
   */
  public Optional<Scene> instance(Scene of, String prototype) {
    SceneStore store = loaded.loader().store();
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
                        new Problems(problems::add)));
  }

  /** A scene of this loader, to be shown. */
  public LoadedScene loaded(Scene scene) {
    return new LoadedScene(scene, loaded.loader());
  }

  /** A scene of nodes of this loader, to be shown. */
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
   * The same, made by a Script.
   *
   * @param asker against whose file urls of the node are resolved
   */
  public Optional<Node> make(Node asker, String type, Location location) {
    Optional<Node> made = make(type, location);
    made.ifPresent(node -> loaded.loader().store().maker(node, origin(asker)));
    return made;
  }

  /** The node types that scenes may have. */
  public NodeCatalogue catalogue() {
    return loaded.loader().catalogue();
  }

  /** A node of a type, with all fields at their defaults; empty if there is no such type. */
  public Optional<Node> make(String type, Location location) {
    return catalogue()
        .find(type)
        .map(found -> loaded.loader().factory().make(found, null, location));
  }

  /** A node that stands for another one and asks for these urls. */
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
  void sound(AudioClipNode clip, Consumer<Optional<Recording>> arrived) {
    request(clip, loaded.loader().late().sound(copy(clip), origin(clip)), arrived);
  }

  /** Reads the text of a part of a shader as it is now. */
  void shader(Node part, Consumer<Optional<ShaderText>> arrived) {
    ParsedNode asking = copy(part);
    asking.put(part.type().indexOf("sourceCode"), part.string("sourceCode"));
    request(
        loaded.loader().late().shader(asking, origin(part)),
        text -> arrived.accept(Optional.of(text)),
        () -> arrived.accept(Optional.empty()));
  }

  /** Tells a problem that was found while the scene runs. */
  void told(Problem problem) {
    problems.add(problem);
  }

  /** The texture for a picture of a Background, with the url that the Background has now. */
  Optional<Node> picture(Node background, Backdrop.Side side) {
    SceneStore store = loaded.loader().store();
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

  private Node newPicture(Node background, Backdrop.Side side) {
    SceneLoader loader = loaded.loader();
    Node texture =
        loader.factory().make(loader.catalogue().get("ImageTexture"), null, background.location());
    loader.store().origin(texture, origin(background));
    loader.store().picture(background, side, texture);
    return texture;
  }

  /** Whether the node came with a file, and what it then named has been read. */
  boolean fromFile(Node node) {
    return loaded.loader().store().origin(node).isPresent();
  }

  /** Metres per unit of the file in which a node stands. */
  double unitLength(Node node) {
    return origin(node).unitLength();
  }

  /** Reads what a node names; LoadSensors hear of it. */
  private <T> void request(
      Node node, CompletableFuture<LateReading.Arrival<T>> reading, Consumer<Optional<T>> arrived) {
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
      CompletableFuture<LateReading.Arrival<T>> reading, Consumer<T> arrived, Runnable failed) {
    reading.thenAccept(
        arrival ->
            arrivals.add(
                arrival.work(),
                () -> {
                  for (Problem problem : arrival.problems()) {
                    problems.add(problem);
                  }
                  arrival.value().ifPresentOrElse(arrived, failed);
                }));
  }

  /** A node that an application made belongs to the scene that runs. */
  private UrlBase origin(Node node) {
    SceneStore store = loaded.loader().store();
    return store
        .origin(node)
        .or(() -> store.maker(node))
        .or(() -> store.origin(loaded.scene().root()))
        .orElseGet(() -> UrlBase.workingFolder(loaded.loader().access()));
  }

  /** A node as it is now, for other threads. */
  private static ParsedNode copy(Node node) {
    ParsedNode copy = new ParsedNode(node.type(), node.name(), node.location());
    int url = node.type().indexOf("url");
    copy.put(url, ((String[]) node.value(url)).clone());
    return copy;
  }
}
