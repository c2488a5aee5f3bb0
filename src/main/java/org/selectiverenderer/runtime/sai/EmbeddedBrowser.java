package org.selectiverenderer.runtime.sai;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import javax.xml.transform.TransformerException;
import javax.xml.transform.TransformerFactory;
import javax.xml.transform.dom.DOMSource;
import javax.xml.transform.stream.StreamResult;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.loading.SceneLoader;
import org.selectiverenderer.runtime.nodes.NodeFactory;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.web3d.x3d.sai.BrowserEvent;
import org.web3d.x3d.sai.BrowserListener;
import org.web3d.x3d.sai.ComponentInfo;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.InvalidBrowserException;
import org.web3d.x3d.sai.InvalidDocumentException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.InvalidURLException;
import org.web3d.x3d.sai.InvalidX3DException;
import org.web3d.x3d.sai.ProfileInfo;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;

/** The embedded browser. Stepping its world is its owner's business. Thread-safe. */
public final class EmbeddedBrowser implements ExternalBrowser {
  private final World world;
  private final SceneLoader loader;
  private final Consumer<String> console;
  private final FrameMeter meter;
  private final SaiTypes types = new SaiTypes();
  private final Values values = new Values(this);
  private final Infos infos;
  private final UpdateBuffer updates = new UpdateBuffer();
  private final CopyOnWriteArrayList<BrowserListener> listeners = new CopyOnWriteArrayList<>();
  private final Map<String, Object> renderingProperties;
  private volatile EmbeddedScene current;
  private volatile String description = "";
  private volatile boolean disposed;

  /**
   * @param console takes what applications print
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
    meter = new FrameMeter(world);
    infos = new Infos(loader.catalogue());
    current = new EmbeddedScene(this, world.scene());
    world.onReplace(
        replaced -> {
          if (current.scene() != replaced.scene()) {
            current = new EmbeddedScene(this, replaced.scene());
          }
          tell(BrowserEvent.INITIALIZED);
        });
  }

  SaiTypes types() {
    return types;
  }

  Values values() {
    return values;
  }

  NodeCatalogue catalogue() {
    return loader.catalogue();
  }

  NodeFactory factory() {
    return loader.factory();
  }

  void check() {
    if (disposed) {
      throw new InvalidBrowserException("the browser is disposed of");
    }
  }

  /** The SAI object of a node, always the same; null for null. */
  @Nullable X3DNode wrap(@Nullable Node node) {
    return node == null ? null : proxy(node, true).proxy();
  }

  X3DNode wrapNew(Node node) {
    return proxy(node, false).proxy();
  }

  private NodeProxy proxy(Node node, boolean realized) {
    synchronized (node) {
      if (node.companion() instanceof NodeProxy known) {
        return known;
      }
      NodeProxy made = new NodeProxy(this, node, realized);
      node.companion(made);
      return made;
    }
  }

  /** The node of an SAI object; null for null. */
  @Nullable Node unwrap(@Nullable X3DNode node) {
    return node == null ? null : unwrapped(node);
  }

  Node unwrapped(X3DNode node) {
    InvocationHandler handler =
        Proxy.isProxyClass(node.getClass()) ? Proxy.getInvocationHandler(node) : null;
    if (handler instanceof NodeProxy proxy) {
      proxy.realize();
      return proxy.node();
    }
    throw new InvalidNodeException("the node is of another browser");
  }

  /** Where a node was read, for messages. */
  public Location locationOf(X3DNode node) {
    return unwrapped(node).location();
  }

  /** Does a change now, at the next step, or at the end of the update that is open. */
  void execute(Runnable change) {
    check();
    if (!updates.hold(change)) {
      world.execute(change);
    }
  }

  void write(Node node, int field, @Nullable Object value) {
    execute(() -> world.cascade().send(node, field, value));
  }

  @Override
  public void beginUpdate() {
    check();
    updates.begin();
  }

  @Override
  public void endUpdate() {
    check();
    List<Runnable> writes = updates.end();
    world.execute(() -> writes.forEach(Runnable::run));
  }

  @Override
  public void addBrowserListener(BrowserListener listener) {
    check();
    listeners.addIfAbsent(listener);
  }

  @Override
  public void removeBrowserListener(BrowserListener listener) {
    check();
    listeners.remove(listener);
  }

  private void tell(int id) {
    BrowserEvent event = new BrowserEvent(this, id);
    for (BrowserListener listener : listeners) {
      try {
        listener.browserChanged(event);
      } catch (RuntimeException e) {
        world
            .problems()
            .error(
                Location.of(world.scene().url()),
                "a browser listener failed and was passed over: " + e.getMessage());
      }
    }
  }

  @Override
  public void dispose() {
    if (!disposed) {
      tell(BrowserEvent.SHUTDOWN);
      disposed = true;
      listeners.clear();
    }
  }

  @Override
  public String getName() {
    check();
    return "Selective Renderer embedded browser";
  }

  @Override
  public String getVersion() {
    check();
    return Optional.ofNullable(EmbeddedBrowser.class.getPackage().getImplementationVersion())
        .orElse("development");
  }

  @Override
  public ProfileInfo[] getSupportedProfiles() {
    check();
    return infos.profiles();
  }

  @Override
  public ProfileInfo getProfile(String name) {
    check();
    return infos.profile(name);
  }

  @Override
  public ComponentInfo[] getSupportedComponents() {
    check();
    return infos.components();
  }

  @Override
  public ComponentInfo getComponentInfo(String name, int level) {
    check();
    return infos.component(name, level);
  }

  @Override
  public X3DExecutionContext getExecutionContext() {
    check();
    return current;
  }

  @Override
  public X3DScene createScene(ProfileInfo profile, ComponentInfo @Nullable [] components) {
    check();
    Map<String, Integer> levels = new LinkedHashMap<>();
    if (components != null) {
      for (ComponentInfo component : components) {
        levels.put(component.getName(), component.getLevel());
      }
    }
    Node root = factory().make(catalogue().get("Group"), null, Location.of("(made)"));
    return new EmbeddedScene(this, new Scene(root, "", "4.0", profile.getName(), levels, 1));
  }

  @Override
  public float getCurrentSpeed() {
    check();
    return (float) meter.speed();
  }

  @Override
  public float getCurrentFrameRate() {
    check();
    return (float) meter.framesPerSecond();
  }

  @Override
  public void replaceWorld(X3DScene scene) {
    check();
    if (!(scene instanceof EmbeddedScene embedded)) {
      throw new InvalidNodeException("the scene is of another browser");
    }
    execute(
        () -> {
          current = embedded;
          world.replace(new LoadedScene(embedded.scene(), loader));
        });
  }

  @Override
  public void loadURL(String[] url, @Nullable Map<String, Object> parameters) {
    check();
    try {
      replaceWorld(createX3DFromURL(url));
    } catch (InvalidURLException e) {
      tell(BrowserEvent.URL_ERROR);
      throw e;
    }
  }

  @Override
  public void setDescription(String newDescription) {
    check();
    description = newDescription;
  }

  @Override
  public String getDescription() {
    check();
    return description;
  }

  @Override
  public X3DScene createX3DFromString(String text) {
    check();
    try (InputStream in = new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))) {
      return read("(text of the application)", in, Path.of(""));
    } catch (IOException e) {
      throw new InvalidX3DException(e.getMessage());
    }
  }

  @Override
  public X3DScene createX3DFromStream(String baseUrl, InputStream stream) throws IOException {
    check();
    return read(baseUrl, stream, Path.of(baseUrl.isBlank() ? "" : baseUrl));
  }

  private X3DScene read(String name, InputStream in, Path folder) throws IOException {
    Scene scene = loader.load(name, in, folder).scene();
    if (scene.root().nodes("children").isEmpty() && world.problems().any()) {
      throw new InvalidX3DException(name + " holds no scene that can be read");
    }
    return new EmbeddedScene(this, scene);
  }

  @Override
  public X3DScene createX3DFromURL(String[] urls) {
    check();
    String reason = "no url is given";
    for (String url : urls) {
      try {
        return new EmbeddedScene(this, loader.load(Path.of(url)).scene());
      } catch (IOException | InvalidPathException e) {
        reason = String.valueOf(e.getMessage());
      }
    }
    throw new InvalidURLException(reason);
  }

  @Override
  public X3DScene importDocument(org.w3c.dom.Node element) {
    check();
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      TransformerFactory.newInstance()
          .newTransformer()
          .transform(new DOMSource(element), new StreamResult(bytes));
      return read(
          "(document of the application)",
          new ByteArrayInputStream(bytes.toByteArray()),
          Path.of(""));
    } catch (TransformerException | IOException e) {
      throw new InvalidDocumentException(e.getMessage());
    }
  }

  @Override
  public void print(Object message) {
    check();
    console.accept(String.valueOf(message));
  }

  @Override
  public void println(Object message) {
    check();
    console.accept(message + System.lineSeparator());
  }

  @Override
  public void nextViewpoint() {
    go(+1);
  }

  @Override
  public void nextViewpoint(int layer) {
    go(+1);
  }

  @Override
  public void previousViewpoint() {
    go(-1);
  }

  @Override
  public void previousViewpoint(int layer) {
    go(-1);
  }

  private void go(int steps) {
    check();
    execute(() -> world.goToViewpoint(steps));
  }

  @Override
  public void firstViewpoint() {
    to(0);
  }

  @Override
  public void firstViewpoint(int layer) {
    to(0);
  }

  @Override
  public void lastViewpoint() {
    to(-1);
  }

  @Override
  public void lastViewpoint(int layer) {
    to(-1);
  }

  private void to(int index) {
    check();
    execute(
        () -> {
          List<Node> all = world.viewpoints();
          if (!all.isEmpty()) {
            world.goTo(all.get(Math.floorMod(index, all.size())));
          }
        });
  }

  @Override
  public Map<String, Object> getRenderingProperties() {
    check();
    return renderingProperties;
  }

  @Override
  public Map<String, Object> getBrowserProperties() {
    check();
    return Map.of(
        "ABSTRACT_NODES", true,
        "CONCRETE_NODES", true,
        "EXTERNAL_INTERACTIONS", true,
        "PROTOTYPE_CREATE", false,
        "DOM_IMPORT", true,
        "XML_ENCODING", true,
        "CLASSIC_VRML_ENCODING", false,
        "BINARY_ENCODING", false);
  }

  @Override
  public void startRender() {
    check();
    world.running(true);
  }

  @Override
  public void pauseRender() {
    check();
    world.running(false);
  }

  @Override
  public void stopRender() {
    check();
    world.running(false);
  }
}
