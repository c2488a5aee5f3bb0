package org.selectiverenderer.walkthrough;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.sai.EmbeddedBrowser;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.ControlProblem;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.budget.VersionBudget;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.selectiverenderer.walkthrough.transition.TransitionTiming;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.MFString;
import org.web3d.x3d.sai.X3DNode;

/**
 * A loaded scene with its selective controller, stepped frame by frame. The same scene, settings,
 * frame times and motion give the same time line, with and without rendering.
 *
 * <p>One thread steps it: the thread that opened it or one to which it is handed over.
 */
public final class Walkthrough implements AutoCloseable {
  /**
   * DEF of the MetadataString by which a scene marks events: a Script or ROUTE sets its {@code
   * value}, of which the last text is the event. Other browsers pass it over.
   */
  public static final String MARKER = "SelectiveRendererEvents";

  private final World world;
  private final SceneLoader loader;
  private final EmbeddedBrowser browser;
  private final TransitionTiming timing;
  private final SelectiveController controller;
  private final ProblemCollector problems;
  private final Consumer<TimelineEvent> timeline;
  private final Optional<VersionBudget> budget;
  private final QualityTally qualities;
  private final List<ControlEvent> early = new ArrayList<>();
  private double firstTime = Double.NaN;
  private long frames;
  private long startPolygons;
  private long maxPolygons;

  private Walkthrough(
      World world,
      SceneLoader loader,
      ProblemCollector problems,
      SelectiveController.Settings settings,
      Consumer<TimelineEvent> timeline,
      Consumer<String> console) {
    this.world = world;
    this.loader = loader;
    this.problems = problems;
    this.timeline = timeline;
    browser = new EmbeddedBrowser(world, loader, console, Map.of());
    timing = new TransitionTiming(world, settings.transition(), browser::nodeOf);
    controller = new SelectiveController(browser, settings, timing, this::heard, this::report);
    budget =
        settings
            .budget()
            .map(limit -> new VersionBudget(world, controller, browser::nodeOf, limit));
    qualities = new QualityTally(controller);
    world.instances().update();
    SourceLocation file = world.scene().root().location();
    controller.idleRules().ifPresent(remark -> problems.warning(file, remark));
  }

  /** Opens a scene that may load only files in its own folder. */
  public static Walkthrough open(
      Path scene,
      SelectiveController.Settings settings,
      Consumer<Problem> problem,
      Consumer<TimelineEvent> timeline,
      Consumer<String> console)
      throws IOException {
    return open(scene, settings, ContentAccessPolicy.none(), problem, timeline, console);
  }

  /**
   * Loads a scene with all its Inlines and attaches the selective controller.
   *
   * @param access the files and URLs that the scene may load besides those in its folder
   * @param problem receives the problems of the scene in document order
   * @param timeline receives the events of the time line in order
   * @param console receives the text that a scene prints through the SAI
   * @throws IOException with a one-line message when the scene cannot be read at all
   */
  public static Walkthrough open(
      Path scene,
      SelectiveController.Settings settings,
      ContentAccessPolicy access,
      Consumer<Problem> problem,
      Consumer<TimelineEvent> timeline,
      Consumer<String> console)
      throws IOException {
    return open(scene, settings, access, world -> {}, problem, timeline, console);
  }

  /**
   * Loads a scene with all its Inlines and attaches the selective controller.
   *
   * @param access the files and URLs that the scene may load besides those in its folder
   * @param loaded receives the world before the controller is attached; to begin with what other
   *     threads can do meanwhile
   * @param problem receives the problems of the scene in document order
   * @param timeline receives the events of the time line in order
   * @param console receives the text that a scene prints through the SAI
   * @throws IOException with a one-line message when the scene cannot be read at all
   */
  public static Walkthrough open(
      Path scene,
      SelectiveController.Settings settings,
      ContentAccessPolicy access,
      Consumer<World> loaded,
      Consumer<Problem> problem,
      Consumer<TimelineEvent> timeline,
      Consumer<String> console)
      throws IOException {
    ProblemCollector problems = new ProblemCollector(problem);
    SceneLoader loader =
        new SceneLoader(
            NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), access, problems);
    try {
      World world = new World(loader.load(scene), problems);
      loaded.accept(world);
      return new Walkthrough(world, loader, problems, settings, timeline, console);
    } catch (IOException | RuntimeException | Error e) {
      loader.close();
      throw e;
    }
  }

  public World world() {
    return world;
  }

  /** Returns the problems of the scene. */
  public ProblemCollector problems() {
    return problems;
  }

  /**
   * Returns whether nothing of the file could be read: there is no node, and the problem has been
   * reported.
   */
  public boolean unreadable() {
    return problems.any()
        && world.scene().root().nodes("children").isEmpty()
        && world.scene().loose().isEmpty();
  }

  /** Returns the areas that contain the viewer, in the order of entering. */
  public List<String> enteredAreas() {
    return controller.enteredAreas();
  }

  /** Returns the active schemas. */
  public List<String> activeSchemas() {
    return controller.activeSchemas();
  }

  /**
   * Sets the choices of Switches by their names, which neither condition nor areas change from now
   * on.
   *
   * @return the names that no Switch of the scene has
   */
  public Set<String> hold(Map<String, Integer> choices) {
    return controller.hold(choices);
  }

  /** Returns what keeps the walkthrough within a budget; empty without one. */
  public Optional<VersionBudget> budget() {
    return budget;
  }

  /** Tells from now on what the viewer sees of each change, as far as rays can tell. */
  public void observeSwitches() {
    timing.observe();
  }

  /**
   * Begins on another thread what frames will need, for a walkthrough whose frames must come in
   * time. Call it before the first frame, after {@link #observeSwitches}.
   */
  public void prepareFrames() {
    timing.prepare();
  }

  /**
   * Listens to the events that the scene marks: each value that {@link #MARKER} gets is passed on.
   */
  public void listen(Consumer<String> marked) {
    marker()
        .map(node -> node.getField("value"))
        .ifPresent(
            field ->
                field.addX3DEventListener(
                    event -> {
                      if (field instanceof MFString texts && texts.getSize() > 0) {
                        marked.accept(texts.get1Value(texts.getSize() - 1));
                      }
                    }));
  }

  private Optional<X3DNode> marker() {
    try {
      X3DNode node = browser.getExecutionContext().getNamedNode(MARKER);
      return Optional.ofNullable(node)
          .filter(found -> found.getNodeName().equals("MetadataString"));
    } catch (InvalidNodeException e) {
      return Optional.empty(); // The scene has no node of that name.
    }
  }

  /**
   * Returns the number of polygons of the whole scene with its current versions, visible or not.
   */
  public long polygons() {
    return world.shownPolygons();
  }

  public long frames() {
    return frames;
  }

  /**
   * Steps one frame.
   *
   * @param time seconds since the start of the walkthrough
   */
  public void step(double time, ViewerMotion motion) {
    if (frames == 0) {
      firstTime = time;
      early.forEach(this::tell);
      early.clear();
    }
    timing.begin(time);
    world.step(time, motion);
    controller.showDue(World.EPOCH + time);
    timing.end();
    qualities.stepped(time);
    if (frames == 0) {
      startPolygons = polygons();
    }
    frames++;
    maxPolygons = Math.max(maxPolygons, polygons());
  }

  /** Reports the end of the walkthrough to the time line. */
  public void end() {
    if (frames > 0) {
      timeline.accept(
          new TimelineEvent.End(
              world.time(),
              frames,
              new TimelineEvent.PolygonSpan(startPolygons, polygons(), maxPolygons),
              controller.waiting(),
              qualities.until(world.time())));
    }
  }

  private void heard(ControlEvent event) {
    if (Double.isNaN(firstTime)) {
      early.add(event);
    } else {
      tell(event);
    }
  }

  /**
   * Reports an event with the time of its frame: the event's own time counts from 1970 and has lost
   * its last digits.
   */
  private void tell(ControlEvent event) {
    double t = Double.isNaN(world.time()) ? firstTime : world.time();
    timeline.accept(new TimelineEvent.ControllerEvent(t, event));
  }

  private void report(ControlProblem problem) {
    SourceLocation place = browser.locationOf(problem.node());
    switch (problem.severity()) {
      case WARNING -> problems.warning(place, problem.toString());
      case INFO -> problems.info(place, problem.toString());
    }
  }

  /** Releases all resources and ends the threads. */
  @Override
  public void close() {
    timing.close();
    controller.close();
    browser.dispose();
    loader.close();
  }
}
