package org.selectiverenderer.browser.sai;

import java.io.IOException;
import java.io.InputStream;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.SafeListenerInvoker;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.sai.InlineSceneAccess;
import org.selectiverenderer.sai.MetadataChangeAccess;
import org.selectiverenderer.sai.NodeNameAccess;
import org.selectiverenderer.sai.ProtoBodyAccess;
import org.web3d.x3d.sai.BrowserEvent;
import org.web3d.x3d.sai.BrowserListener;
import org.web3d.x3d.sai.ComponentInfo;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.InvalidExecutionContextException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.InvalidURLException;
import org.web3d.x3d.sai.InvalidX3DException;
import org.web3d.x3d.sai.ProfileInfo;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;

/** The embedded browser behind the SAI. Its owner steps its world. Thread-safe. */
public final class EmbeddedBrowser
    implements ExternalBrowser,
        InlineSceneAccess,
        ProtoBodyAccess,
        NodeNameAccess,
        MetadataChangeAccess {
  /**
   * An event of this browser's own: nodes were added or removed at the top of the scene it shows.
   */
  public static final int ROOTS_CHANGED = BrowserEvent.LAST_IDENTIFIER + 1;

  private final World world;
  private final SceneLoader loader;
  private final Consumer<String> console;
  private final Map<String, Object> renderingProperties;
  private final SaiContext binding;
  private final BrowserCapabilities infos;
  private final SceneFactory scenes;
  private final ViewpointNavigator viewpoints;
  private final BrowserListenerList listeners;
  private final FrameRateMeter meter;
  private volatile EmbeddedScene current;
  private RootNodeWatcher roots;
  private volatile String description = "";

  /**
   * @param console receives what applications print
   * @param renderingProperties as {@link #getRenderingProperties()} returns them
   */
  public EmbeddedBrowser(
      World world,
      SceneLoader loader,
      Consumer<String> console,
      Map<String, Object> renderingProperties) {
    this.world = world;
    this.loader = loader;
    this.console = console;
    this.renderingProperties = Map.copyOf(renderingProperties);
    binding = new SaiContext(world);
    infos = new BrowserCapabilities(loader.catalogue());
    scenes = new SceneFactory(binding, loader, infos);
    viewpoints = new ViewpointNavigator(world, binding);
    listeners = new BrowserListenerList(world);
    meter = new FrameRateMeter(world);
    current = shown(world.scene());
    roots = new RootNodeWatcher(world.scene(), time -> tell(ROOTS_CHANGED));
    world.onReplace(this::replaced);
  }

  private EmbeddedScene shown(Scene scene) {
    // The URL is made when asked for: whether it is a file's is a question to the disk.
    EmbeddedScene shown = new EmbeddedScene(binding, scenes, scene, null);
    shown.show();
    return shown;
  }

  private void replaced(World shownBy) {
    if (!current.isOf(shownBy.scene())) {
      current = shown(shownBy.scene());
    }
    roots.close();
    roots = new RootNodeWatcher(shownBy.scene(), time -> tell(ROOTS_CHANGED));
    tell(BrowserEvent.INITIALIZED);
  }

  private void tell(int id) {
    listeners.tell(new BrowserEvent(this, id));
  }

  /** Returns where in a file a node was read, for messages. */
  public SourceLocation locationOf(X3DNode node) {
    return binding.peek(node).location();
  }

  /** Returns the node of the world behind a node of the SAI; of a prototype instance, its body. */
  public Node nodeOf(X3DNode node) {
    return binding.body(node);
  }

  @Override
  public Optional<X3DScene> inlinedScene(X3DNode inline) {
    return inlineOf(inline).shown().map(this::shown);
  }

  @Override
  public X3DNode bodyOf(X3DNode node) {
    return binding.exactly(binding.body(node));
  }

  @Override
  public Map<X3DNode, String> namesOf(X3DExecutionContext scene, Set<X3DNode> nodes) {
    if (scene instanceof EmbeddedScene own && own.binding() == binding) {
      return own.namesOf(nodes);
    }
    throw new InvalidExecutionContextException("the scene belongs to another browser");
  }

  @Override
  public boolean mayHold(X3DNode inline, Set<String> types) {
    Scene content = inlineOf(inline).shown().orElse(null);
    return content != null
        && (content.mayGrow() || !Collections.disjoint(types, content.types().orElseThrow()));
  }

  @Override
  public Registration watchInline(X3DNode inline, Listener listener) {
    return new InlineWatcher(world, binding.proxyOf(inline), inlineOf(inline), listener);
  }

  @Override
  public Optional<Registration> watchMetadata(X3DNode owner, DoubleConsumer listener) {
    return MetadataTreeWatcher.of(world.cascade(), binding.proxyOf(owner), listener);
  }

  private InlineNode inlineOf(X3DNode node) {
    if (binding.body(node) instanceof InlineNode inline) {
      return inline;
    }
    throw new InvalidNodeException(node.getNodeName() + " is not an Inline");
  }

  @Override
  public void beginUpdate() {
    binding.beginUpdate();
  }

  @Override
  public void endUpdate() {
    binding.endUpdate();
  }

  @Override
  public void addBrowserListener(BrowserListener listener) {
    binding.check();
    listeners.add(listener);
  }

  @Override
  public void removeBrowserListener(BrowserListener listener) {
    binding.check();
    listeners.remove(listener);
  }

  @Override
  public void dispose() {
    if (!binding.disposed()) {
      tell(BrowserEvent.SHUTDOWN);
      binding.dispose();
      listeners.clear();
    }
  }

  @Override
  public String getName() {
    binding.check();
    return "Selective Renderer embedded browser";
  }

  @Override
  public String getVersion() {
    binding.check();
    return Optional.ofNullable(EmbeddedBrowser.class.getPackage().getImplementationVersion())
        .orElse("development");
  }

  @Override
  public ProfileInfo[] getSupportedProfiles() {
    binding.check();
    return infos.profiles();
  }

  @Override
  public ProfileInfo getProfile(String name) {
    binding.check();
    return infos.profile(name);
  }

  @Override
  public ComponentInfo[] getSupportedComponents() {
    binding.check();
    return infos.components();
  }

  @Override
  public ComponentInfo getComponentInfo(String name, int level) {
    binding.check();
    return infos.component(name, level);
  }

  @Override
  public X3DExecutionContext getExecutionContext() {
    binding.check();
    return current;
  }

  @Override
  public X3DScene createScene(ProfileInfo profile, ComponentInfo @Nullable [] components) {
    binding.check();
    return scenes.empty(profile, components);
  }

  @Override
  public X3DScene createX3DFromString(String text) {
    binding.check();
    return scenes.fromText(text);
  }

  @Override
  public X3DScene createX3DFromStream(String baseUrl, InputStream stream) throws IOException {
    binding.check();
    return scenes.fromStream(baseUrl, stream);
  }

  @Override
  public X3DScene createX3DFromURL(String[] urls) {
    binding.check();
    return scenes.fromUrl(urls);
  }

  @Override
  public X3DScene importDocument(org.w3c.dom.Node element) {
    binding.check();
    return scenes.fromDocument(element);
  }

  @Override
  public void replaceWorld(X3DScene scene) {
    binding.check();
    if (!(scene instanceof EmbeddedScene embedded) || embedded.binding() != binding) {
      throw new InvalidNodeException("the scene belongs to another browser");
    }
    Scene shown = embedded.scene();
    embedded.show();
    binding.execute(
        () -> {
          current = embedded;
          world.replace(new LoadedScene(shown, loader));
        });
  }

  @Override
  public void loadURL(String[] url, @Nullable Map<String, Object> parameters) {
    X3DScene scene;
    try {
      scene = createX3DFromURL(url);
    } catch (InvalidURLException | InvalidX3DException e) {
      tell(BrowserEvent.URL_ERROR);
      throw e;
    }
    replaceWorld(scene);
  }

  @Override
  public float getCurrentSpeed() {
    binding.check();
    return (float) meter.speed();
  }

  @Override
  public float getCurrentFrameRate() {
    binding.check();
    return (float) meter.framesPerSecond();
  }

  @Override
  public void setDescription(String newDescription) {
    binding.check();
    description = newDescription;
  }

  @Override
  public String getDescription() {
    binding.check();
    return description;
  }

  @Override
  public void print(Object message) {
    binding.check();
    console.accept(String.valueOf(message));
  }

  @Override
  public void println(Object message) {
    binding.check();
    console.accept(message + System.lineSeparator());
  }

  @Override
  public void nextViewpoint() {
    viewpoints.go(+1);
  }

  @Override
  public void nextViewpoint(int layer) {
    viewpoints.go(+1);
  }

  @Override
  public void previousViewpoint() {
    viewpoints.go(-1);
  }

  @Override
  public void previousViewpoint(int layer) {
    viewpoints.go(-1);
  }

  @Override
  public void firstViewpoint() {
    viewpoints.first();
  }

  @Override
  public void firstViewpoint(int layer) {
    viewpoints.first();
  }

  @Override
  public void lastViewpoint() {
    viewpoints.last();
  }

  @Override
  public void lastViewpoint(int layer) {
    viewpoints.last();
  }

  @Override
  public Map<String, Object> getRenderingProperties() {
    binding.check();
    return renderingProperties;
  }

  @Override
  public Map<String, Object> getBrowserProperties() {
    binding.check();
    return BrowserCapabilities.browserProperties();
  }

  @Override
  public void startRender() {
    binding.check();
    world.running(true);
  }

  @Override
  public void pauseRender() {
    binding.check();
    world.running(false);
  }

  @Override
  public void stopRender() {
    binding.check();
    world.running(false);
  }

  /**
   * Binds the next, previous, first or last viewpoint of the scene that is shown. Layer numbers are
   * ignored.
   */
  private static final class ViewpointNavigator {
    private final World world;
    private final SaiContext binding;

    ViewpointNavigator(World world, SaiContext binding) {
      this.world = world;
      this.binding = binding;
    }

    /**
     * Binds a viewpoint relative to the bound one, cyclically.
     *
     * @param steps +1 for the next, -1 for the previous one
     */
    void go(int steps) {
      binding.execute(() -> world.views().goToViewpoint(steps));
    }

    void first() {
      to(0);
    }

    void last() {
      to(-1);
    }

    private void to(int index) {
      binding.execute(
          () -> {
            List<Node> all = world.views().viewpoints();
            if (!all.isEmpty()) {
              world.views().goTo(all.get(Math.floorMod(index, all.size())));
            }
          });
    }
  }

  /** The listeners of a browser's events, in the order of their registration. Thread-safe. */
  private static final class BrowserListenerList {
    private final World world;
    private final CopyOnWriteArrayList<BrowserListener> listeners = new CopyOnWriteArrayList<>();

    BrowserListenerList(World world) {
      this.world = world;
    }

    void add(BrowserListener listener) {
      listeners.addIfAbsent(listener);
    }

    void remove(BrowserListener listener) {
      listeners.remove(listener);
    }

    void clear() {
      listeners.clear();
    }

    void tell(BrowserEvent event) {
      for (BrowserListener listener : listeners) {
        SafeListenerInvoker.call(
            world.problems(),
            SourceLocation.of(world.scene().url()),
            "a browser listener",
            () -> listener.browserChanged(event));
      }
    }
  }

  /** Measures the frame rate and the viewer's speed. Read from any thread. */
  private static final class FrameRateMeter {
    private static final double SMOOTHING = 0.1;

    private final World world;
    private final Vector3d last = new Vector3d();
    private long lastNanos;
    private double lastTime = Double.NaN;
    private volatile double interval;
    private volatile double speed;

    FrameRateMeter(World world) {
      this.world = world;
      world.onStep(this::frame);
    }

    private void frame() {
      long now = System.nanoTime();
      if (!Double.isNaN(lastTime)) {
        double seconds = (now - lastNanos) * 1e-9;
        interval = interval == 0 ? seconds : interval + SMOOTHING * (seconds - interval);
        double dt = world.time() - lastTime;
        speed = dt > 0 ? last.distance(world.viewer().position()) / dt : 0;
      }
      lastNanos = now;
      lastTime = world.time();
      last.set(world.viewer().position());
    }

    /** Returns the frames per second of wall-clock time, smoothed over about ten frames. */
    double framesPerSecond() {
      return interval == 0 ? 0 : 1 / interval;
    }

    /**
     * Returns the viewer's speed over the last frame, in units of length per second of the scene's
     * time.
     */
    double speed() {
      return speed;
    }
  }
}
