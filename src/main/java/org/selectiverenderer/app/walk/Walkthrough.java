package org.selectiverenderer.app.walk;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.ControlProblem;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.loading.SceneLoader;
import org.selectiverenderer.runtime.nodes.NodeFactory;
import org.selectiverenderer.runtime.sai.EmbeddedBrowser;
import org.selectiverenderer.runtime.viewer.ViewerMotion;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.files.ContentAccess;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * A scene under the controller, ready to be walked through. Each step is a frame; with the same
 * scene, settings, times and motion the same time line comes out, with and without a picture.
 *
 * <p>One thread steps it, the one that opened it or one that it is handed over to.
 */
public final class Walkthrough implements AutoCloseable {
  private final World world;
  private final SceneLoader loader;
  private final EmbeddedBrowser browser;
  private final SelectiveController controller;
  private final Problems problems;
  private final Consumer<TimelineEvent> timeline;
  private final List<ControlEvent> early = new ArrayList<>();
  private double firstTime = Double.NaN;
  private long frames;
  private long startPolygons;
  private long maxPolygons;

  private Walkthrough(
      World world,
      SceneLoader loader,
      Problems problems,
      SelectiveController.Settings settings,
      Consumer<TimelineEvent> timeline,
      Consumer<String> console) {
    this.world = world;
    this.loader = loader;
    this.problems = problems;
    this.timeline = timeline;
    browser = new EmbeddedBrowser(world, loader, console, Map.of());
    controller = new SelectiveController(browser, settings, this::heard, this::report);
    world.instances().update();
  }

  /** As the other, for a scene that may name no more than its own files. */
  public static Walkthrough open(
      Path scene,
      SelectiveController.Settings settings,
      Consumer<Problem> problem,
      Consumer<TimelineEvent> timeline,
      Consumer<String> console)
      throws IOException {
    return open(scene, settings, ContentAccess.none(), problem, timeline, console);
  }

  /**
   * Loads a scene with everything that it inlines and puts it under the controller.
   *
   * @param access what the scene may name besides its own files
   * @param problem hears what is wrong with the scene, in document order
   * @param timeline hears what happens, in order
   * @param console takes what a scene prints through the SAI
   * @throws IOException with a one-line message when the scene cannot be read at all
   */
  public static Walkthrough open(
      Path scene,
      SelectiveController.Settings settings,
      ContentAccess access,
      Consumer<Problem> problem,
      Consumer<TimelineEvent> timeline,
      Consumer<String> console)
      throws IOException {
    Problems problems = new Problems(problem);
    SceneLoader loader =
        new SceneLoader(
            NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), access, problems);
    try {
      LoadedScene loaded = loader.load(scene);
      World world = new World(loaded, problems);
      return new Walkthrough(world, loader, problems, settings, timeline, console);
    } catch (IOException | RuntimeException | Error e) {
      loader.close();
      throw e;
    }
  }

  public World world() {
    return world;
  }

  /** What is wrong with the scene. */
  public Problems problems() {
    return problems;
  }

  /** Whether nothing of the file could be read: no node is there, and why has been said. */
  public boolean unreadable() {
    return problems.any()
        && world.scene().root().nodes("children").isEmpty()
        && world.scene().loose().isEmpty();
  }

  /** The areas that the viewer is in, in the order of entering. */
  public List<String> enteredAreas() {
    return controller.enteredAreas();
  }

  /** The schemas in force. */
  public List<String> activeSchemas() {
    return controller.activeSchemas();
  }

  /** Polygons of the whole scene in its present versions, seen or not. */
  public long polygons() {
    return world.shownPolygons();
  }

  public long frames() {
    return frames;
  }

  /**
   * One frame.
   *
   * @param time seconds since the beginning of the walk
   */
  public void step(double time, ViewerMotion motion) {
    if (frames == 0) {
      firstTime = time;
      early.forEach(this::tell);
      early.clear();
    }
    world.step(time, motion);
    if (frames == 0) {
      startPolygons = polygons();
    }
    frames++;
    maxPolygons = Math.max(maxPolygons, polygons());
  }

  /** Tells the end of the walk. */
  public void end() {
    if (frames > 0) {
      timeline.accept(
          new TimelineEvent.End(
              world.time(),
              frames,
              new TimelineEvent.PolygonSpan(startPolygons, polygons(), maxPolygons)));
    }
  }

  private void heard(ControlEvent event) {
    if (Double.isNaN(firstTime)) {
      early.add(event);
    } else {
      tell(event);
    }
  }

  /** The frame's own time: the event's, counted from 1970, has lost its last digits. */
  private void tell(ControlEvent event) {
    double t = Double.isNaN(world.time()) ? firstTime : world.time();
    timeline.accept(new TimelineEvent.Told(t, event));
  }

  private void report(ControlProblem problem) {
    Location place = browser.locationOf(problem.node());
    switch (problem.severity()) {
      case WARNING -> problems.warning(place, problem.toString());
      case INFO -> problems.info(place, problem.toString());
    }
  }

  /** Lets everything go; threads end. */
  @Override
  public void close() {
    controller.close();
    browser.dispose();
    loader.close();
  }
}
