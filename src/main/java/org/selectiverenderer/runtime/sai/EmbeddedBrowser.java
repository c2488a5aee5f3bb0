package org.selectiverenderer.runtime.sai;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.loading.SceneLoader;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.sai.InlinedScenes;
import org.selectiverenderer.sai.InstanceBodies;
import org.web3d.x3d.sai.BrowserEvent;
import org.web3d.x3d.sai.BrowserListener;
import org.web3d.x3d.sai.ComponentInfo;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.InvalidURLException;
import org.web3d.x3d.sai.InvalidX3DException;
import org.web3d.x3d.sai.ProfileInfo;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;

/** The embedded browser behind the SAI. Its owner steps its world. Thread-safe. */
public final class EmbeddedBrowser implements ExternalBrowser, InlinedScenes, InstanceBodies {
  /**
   * An event of this browser's own: nodes were added or removed at the top of the scene it shows.
   */
  public static final int ROOTS_CHANGED = BrowserEvent.LAST_IDENTIFIER + 1;

  private final World world;
  private final SceneLoader loader;
  private final Consumer<String> console;
  private final Map<String, Object> renderingProperties;
  private final Binding binding;
  private final Infos infos;
  private final SceneMaker scenes;
  private final BoundViewpoints viewpoints;
  private final BrowserListeners listeners;
  private final FrameMeter meter;
  private volatile EmbeddedScene current;
  private RootWatch roots;
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
    binding = new Binding(world);
    infos = new Infos(loader.catalogue());
    scenes = new SceneMaker(binding, loader, infos);
    viewpoints = new BoundViewpoints(world, binding);
    listeners = new BrowserListeners(world);
    meter = new FrameMeter(world);
    current = shown(world.scene());
    roots = new RootWatch(world.scene(), time -> tell(ROOTS_CHANGED));
    world.onReplace(this::replaced);
  }

  private EmbeddedScene shown(Scene scene) {
    EmbeddedScene shown = new EmbeddedScene(binding, scenes, scene, Addresses.urlOf(scene.url()));
    shown.show();
    return shown;
  }

  private void replaced(World shownBy) {
    if (!current.isOf(shownBy.scene())) {
      current = shown(shownBy.scene());
    }
    roots.close();
    roots = new RootWatch(shownBy.scene(), time -> tell(ROOTS_CHANGED));
    tell(BrowserEvent.INITIALIZED);
  }

  private void tell(int id) {
    listeners.tell(new BrowserEvent(this, id));
  }

  /** Returns where in a file a node was read, for messages. */
  public Location locationOf(X3DNode node) {
    return binding.peek(node).location();
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
  public boolean mayHold(X3DNode inline, Set<String> types) {
    Scene content = inlineOf(inline).shown().orElse(null);
    return content != null
        && (content.mayGrow() || content.types().orElseThrow().stream().anyMatch(types::contains));
  }

  @Override
  public Registration watchInline(X3DNode inline, Listener listener) {
    return new InlineWatch(world, binding.proxyOf(inline), inlineOf(inline), listener);
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
    return Infos.browserProperties();
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
}
