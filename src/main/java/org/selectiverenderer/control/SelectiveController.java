package org.selectiverenderer.control;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.sai.InlinedScenes;
import org.selectiverenderer.sai.InstanceBodies;
import org.selectiverenderer.schema.Activation;
import org.web3d.x3d.sai.BrowserEvent;
import org.web3d.x3d.sai.BrowserListener;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.X3DNode;

/**
 * Renders the scene of a browser selectively: listens to its ProximitySensors and sets {@code
 * whichChoice} of its Switches (thesis Figs 48 and 49).
 *
 * <p>Only nodes with metadata of the vocabulary count; others are left alone. The scene is read
 * once when control begins and followed from there: children and metadata that change, nodes that
 * come and go, and another world in place of this one. The scenes of Inlines are part of it where
 * the browser opens them ({@link InlinedScenes}), as if the files were one; the standard keeps them
 * closed, which is said then. So are the bodies of prototypes' instances ({@link InstanceBodies}).
 *
 * <p>The controller keeps its own record of what each Switch shows, since a browser may let a write
 * take effect later than it is made, and writes only what differs. What others write (a ROUTE, an
 * application) is taken into the record and stays until an area has another say. A write is made
 * within the call of the listener, so that it belongs to the same time stamp as the entry.
 *
 * <p>All work is done on the thread of the browser, which is also the one to call the methods here.
 * A browser with several threads, as Xj3D, is heard one event at a time.
 */
public final class SelectiveController implements AutoCloseable {
  /**
   * How a scene is to be rendered.
   *
   * @param seed of the lot of {@link Condition#RANDOM}
   */
  public record Settings(Condition condition, long seed) {
    /** Selective rendering as in the thesis. */
    public static final Settings SELECTIVE = new Settings(Condition.SELECTIVE, 0);
  }

  private final ExternalBrowser browser;
  private final Settings settings;
  private final Consumer<ControlEvent> events;
  private final Consumer<ControlProblem> problems;
  private final BrowserListener onBrowser = this::browserChanged;
  private @Nullable SceneControl scene;

  /**
   * Takes control of the scene that the browser shows, and of every scene that it will show.
   *
   * @param events hears what happens, on the thread of the browser; a {@link ControlEvent.Start}
   *     for each scene first
   * @param problems hears what is wrong with each scene, at its start and later, on the same thread
   */
  public SelectiveController(
      ExternalBrowser browser,
      Settings settings,
      Consumer<ControlEvent> events,
      Consumer<ControlProblem> problems) {
    this.browser = browser;
    this.settings = settings;
    this.events = events;
    this.problems = problems;
    browser.addBrowserListener(onBrowser);
    attach();
  }

  /** What is wrong with the metadata of the scene now, in the order of the scene. */
  public synchronized List<ControlProblem> problems() {
    return scene == null ? List.of() : scene.problems();
  }

  /** The names of the areas that the viewer is in, in the order of entering. */
  public synchronized List<String> enteredAreas() {
    return scene == null ? List.of() : scene.enteredAreas();
  }

  /** The schemas in force, as {@link Activation#activeSchemas()} orders them. */
  public synchronized List<String> activeSchemas() {
    return scene == null ? List.of() : scene.activeSchemas();
  }

  /** The choice that each enriched Switch shows, by name, in the order of the scene. */
  public synchronized Map<String, Integer> choices() {
    return scene == null ? Map.of() : scene.choices();
  }

  /**
   * Looks for nodes that were added or removed at the top of the scene. The SAI does not tell; a
   * browser that sends an event of its own for it, as the embedded one does, makes the controller
   * look by itself.
   */
  public synchronized void rescan() {
    if (scene != null) {
      scene.rescan();
    }
  }

  /** Lets the browser go: no listener stays behind, and every Switch stays as it is. */
  @Override
  public synchronized void close() {
    browser.removeBrowserListener(onBrowser);
    detach();
  }

  private synchronized void browserChanged(BrowserEvent event) {
    if (event.getID() == BrowserEvent.INITIALIZED) {
      attach();
    } else if (event.getID() == BrowserEvent.SHUTDOWN) {
      detach();
    } else if (event.getID() > BrowserEvent.LAST_IDENTIFIER) { // the browser's own affair
      rescan();
    }
  }

  private synchronized void attach() {
    detach();
    var context = browser.getExecutionContext();
    if (context != null) { // no world is shown yet
      scene =
          new SceneControl(context, new Turn(this), opener(), bodies(), settings, events, problems);
      scene.start();
    }
  }

  private @Nullable InlinedScenes opener() {
    return browser instanceof InlinedScenes opening ? opening : null;
  }

  private UnaryOperator<X3DNode> bodies() {
    return browser instanceof InstanceBodies opening ? opening::bodyOf : UnaryOperator.identity();
  }

  private void detach() {
    if (scene != null) {
      scene.close();
      scene = null;
    }
  }
}
