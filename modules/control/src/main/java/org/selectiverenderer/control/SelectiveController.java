package org.selectiverenderer.control;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.control.budget.RenderingBudget;
import org.selectiverenderer.sai.InlineSceneAccess;
import org.selectiverenderer.sai.NodeNameAccess;
import org.selectiverenderer.sai.ProtoBodyAccess;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.QualityRule;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SwitchTransition;
import org.web3d.x3d.sai.BrowserEvent;
import org.web3d.x3d.sai.BrowserListener;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.X3DNode;

/**
 * The selective rendering controller: listens to the ProximitySensors of a browser's scene and sets
 * {@code whichChoice} of its Switches (thesis Figs 48 and 49).
 *
 * <p>Only nodes with metadata of the vocabulary count; others are ignored. The scene is read once
 * when control begins, and all changes are followed: of children and metadata, nodes that are added
 * or removed, and the replacement of the world. The scenes of Inlines are included where the
 * browser gives access to them ({@link InlineSceneAccess}), as if the files were one; with a
 * browser that only follows the standard a problem reports that they are not. The bodies of
 * prototype instances are treated likewise ({@link ProtoBodyAccess}).
 *
 * <p>The controller keeps its own record of what each Switch shows, since a browser may let a write
 * take effect later than it is made, and writes only what differs. A choice that others write (a
 * ROUTE, an application) is recorded and stays until an area activates another one. A write is made
 * within the call of the listener, so that it belongs to the same time stamp as the entry.
 *
 * <p>All work is done on the browser's thread, which must also be the one that calls the methods
 * here. Events of a browser with several threads, such as Xj3D, are handled one at a time.
 */
public final class SelectiveController implements AutoCloseable {
  /**
   * The condition and random seed with which a scene is rendered.
   *
   * @param seed the random seed of {@link Condition#RANDOM}
   * @param held the choices of Switches, by name, that neither condition nor areas change
   * @param controls whether choices are set; else the controller only tells what happens
   * @param transition how versions change; a {@link SwitchTiming} acts on it
   * @param budget what a frame may cost: then areas change no Switch, they only tell how consistent
   *     objects are, and whoever keeps the budget chooses by {@link #choose}
   * @param qualities what decides the levels of qualities, where the condition does not
   */
  public record Settings(
      Condition condition,
      long seed,
      Map<String, Integer> held,
      boolean controls,
      SwitchTransition transition,
      Optional<RenderingBudget> budget,
      Map<Quality, QualityRule> qualities) {
    /** Selective rendering as in the thesis. */
    public static final Settings SELECTIVE = new Settings(Condition.SELECTIVE, 0);

    /**
     * A scene that is left to itself, such as an exported one with a Script of its own: the areas
     * that are entered are told, and the choices that the scene sets.
     */
    public static final Settings OBSERVING = new Settings(Condition.SELECTIVE, 0, Map.of(), false);

    /** Copies the choices. */
    public Settings {
      held = Map.copyOf(held);
      qualities = Map.copyOf(qualities);
      if (budget.isPresent() && !(controls && condition.switches())) {
        throw new IllegalArgumentException("a budget chooses in the selective condition only");
      }
    }

    /** Creates settings in which the condition determines all choices. */
    public Settings(Condition condition, long seed) {
      this(condition, seed, Map.of());
    }

    /** Creates settings in which the condition determines the choices that are not held. */
    public Settings(Condition condition, long seed, Map<String, Integer> held) {
      this(condition, seed, held, true);
    }

    /** Returns the same settings with rules for some qualities apart. */
    public Settings with(Map<Quality, QualityRule> rules) {
      return new Settings(condition, seed, held, controls, transition, budget, rules);
    }

    /** Returns what decides a quality apart from the condition; empty if the condition does. */
    Optional<QualityRule> rule(Quality quality) {
      return Optional.ofNullable(qualities.get(quality));
    }

    /** Returns whether areas change a quality as the viewer walks. */
    boolean follows(Quality quality) {
      return rule(quality).map(QualityRule.SELECTIVE::equals).orElse(condition.switches());
    }

    /** Creates settings in which versions change at once. */
    public Settings(Condition condition, long seed, Map<String, Integer> held, boolean controls) {
      this(condition, seed, held, controls, SwitchTransition.AT_ONCE, Optional.empty(), Map.of());
    }

    /** Returns these settings with another transition. */
    public Settings with(SwitchTransition changed) {
      return new Settings(condition, seed, held, controls, changed, budget, qualities);
    }

    /**
     * Returns these settings with a budget.
     *
     * @throws IllegalArgumentException if the condition is another than the selective one
     */
    public Settings within(RenderingBudget limit) {
      return new Settings(
          condition, seed, held, controls, transition, Optional.of(limit), qualities);
    }
  }

  private final ExternalBrowser browser;
  private final Settings settings;
  private final SwitchTiming timing;
  private final Consumer<ControlEvent> events;
  private final Consumer<ControlProblem> problems;
  private final BrowserListener onBrowser = this::browserChanged;
  private @Nullable SceneController scene;
  private long levelsBefore;

  /**
   * Takes control of the scene that the browser shows, and of every scene that it will show.
   *
   * @param events receives the events, on the browser's thread; for each scene a {@link
   *     ControlEvent.Start} first
   * @param problems receives the problems of each scene, at its start and later, on the same thread
   */
  public SelectiveController(
      ExternalBrowser browser,
      Settings settings,
      Consumer<ControlEvent> events,
      Consumer<ControlProblem> problems) {
    this(browser, settings, SwitchTiming.AT_ONCE, events, problems);
  }

  /**
   * Takes control of the scene that the browser shows, and of every scene that it will show, with
   * choices that may have to wait.
   *
   * @param timing decides when choices are shown; see {@link #showDue}
   * @param events receives the events, on the browser's thread; for each scene a {@link
   *     ControlEvent.Start} first
   * @param problems receives the problems of each scene, at its start and later, on the same thread
   */
  public SelectiveController(
      ExternalBrowser browser,
      Settings settings,
      SwitchTiming timing,
      Consumer<ControlEvent> events,
      Consumer<ControlProblem> problems) {
    this.browser = browser;
    this.settings = settings;
    this.timing = timing;
    this.events = events;
    this.problems = problems;
    browser.addBrowserListener(onBrowser);
    attach();
  }

  /** Returns the present problems of the scene's metadata, in the order of the scene. */
  public synchronized List<ControlProblem> problems() {
    return scene == null ? List.of() : scene.problems();
  }

  /** Returns the names of the areas that the viewer is in, in the order of entering. */
  public synchronized List<String> enteredAreas() {
    return scene == null ? List.of() : scene.enteredAreas();
  }

  /** Returns the active schemas in the order of {@link SchemaActivation#activeSchemas()}. */
  public synchronized List<String> activeSchemas() {
    return scene == null ? List.of() : scene.activeSchemas();
  }

  /** Returns the choice that each enriched Switch shows, by name, in the order of the scene. */
  public synchronized Map<String, Integer> choices() {
    return scene == null ? Map.of() : scene.choices();
  }

  /** Returns the number of fields that have each level, by quality; level -1 is none. */
  public synchronized Map<Quality, Map<Integer, Integer>> levels() {
    return scene == null ? Map.of() : scene.levelCounts();
  }

  /** Returns a number that changes when {@link #levels} may have. */
  public synchronized long levelsVersion() {
    return levelsBefore + (scene == null ? 0 : scene.levelsVersion());
  }

  /**
   * Sets the choices of Switches, which from now on nothing else that the controller does changes.
   * A Switch needs no metadata for that; one that comes later is set when it comes.
   *
   * @param choices {@code whichChoice} by the Switches' names
   * @return the names that no Switch of the scene has
   */
  public synchronized Set<String> hold(Map<String, Integer> choices) {
    return scene == null ? Set.copyOf(choices.keySet()) : scene.hold(choices);
  }

  /**
   * Returns a remark about rules of qualities that no object of the scene has, which change nothing
   * so far; empty where each is some object's.
   */
  public synchronized Optional<String> idleRules() {
    Set<Quality> found = scene == null ? Set.of() : scene.qualities();
    String idle = spelled(settings.qualities().keySet().stream().filter(q -> !found.contains(q)));
    return idle.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "no object of the scene has levels of %s yet, so setting them changes nothing; %s"
                .formatted(
                    idle,
                    found.isEmpty()
                        ? "no object is enriched"
                        : "the scene has " + spelled(found.stream())));
  }

  private static String spelled(Stream<Quality> qualities) {
    return qualities.sorted().map(Quality::spelling).collect(Collectors.joining(", "));
  }

  /**
   * Returns the enriched objects whose versions differ in their polygons and are not held, in the
   * order of the scene: those of which a budget chooses versions. It is the same list until it has
   * other objects or their metadata change.
   */
  public synchronized List<ChoosableObject> choosable() {
    return scene == null ? List.of() : scene.choosable();
  }

  /** Returns a number that changes when the consistency of one of these objects may have. */
  public synchronized long consistencyVersion() {
    return scene == null ? 0 : scene.consistencyVersion();
  }

  /**
   * Shows a version that a budget has chosen, as soon as it may be shown.
   *
   * @param object of the scene that is shown; one of another scene is passed over
   * @param version from 0 to below {@link ChoosableObject#versions}
   * @param time the browser's time stamp in seconds
   */
  public synchronized void choose(ChoosableObject object, int version, double time) {
    if (scene != null) {
      scene.choose(object, version, time);
    }
  }

  /**
   * Shows the choices that wait and may be shown now. To be called in every frame, after the viewer
   * has moved.
   *
   * @param time the browser's time stamp in seconds
   */
  public synchronized void showDue(double time) {
    if (scene != null) {
      scene.showDue(time);
    }
  }

  /** Returns the choices that wait to be shown, by the names of their Switches. */
  public synchronized Map<String, Integer> waiting() {
    return scene == null ? Map.of() : scene.waiting();
  }

  /**
   * Looks for root nodes that were added to or removed from the scene, for which the SAI has no
   * event. With a browser that sends an event of its own for it, as the embedded one does, the
   * controller looks by itself.
   */
  public synchronized void rescan() {
    if (scene != null) {
      scene.rescan();
    }
  }

  /** Ends the control: removes all listeners from the browser, and leaves every Switch as it is. */
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
    } else if (event.getID() > BrowserEvent.LAST_IDENTIFIER) { // an event of the browser's own
      rescan();
    }
  }

  private synchronized void attach() {
    detach();
    var context = browser.getExecutionContext();
    if (context != null) { // no world is shown yet
      scene =
          new SceneController(
              context,
              new ListenerLock(this),
              opener(),
              bodies(),
              browser instanceof NodeNameAccess names ? names : null,
              settings,
              timing,
              events,
              problems);
      scene.start();
    }
  }

  private @Nullable InlineSceneAccess opener() {
    return browser instanceof InlineSceneAccess opening ? opening : null;
  }

  private UnaryOperator<X3DNode> bodies() {
    return browser instanceof ProtoBodyAccess opening ? opening::bodyOf : UnaryOperator.identity();
  }

  private void detach() {
    if (scene != null) {
      levelsBefore += scene.levelsVersion() + 1;
      scene.close();
      scene = null;
    }
  }
}
