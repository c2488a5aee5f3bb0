package org.selectiverenderer.bench.versions;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.sai.EmbeddedBrowser;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.PathMotion;
import org.selectiverenderer.control.ChoosableObject;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.budget.ObjectPlaces;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** A scene on a path, whose versions the controller or a rule of the comparison chooses. */
final class ControlledWorld implements AutoCloseable {
  private final SceneLoader loader;
  private final EmbeddedBrowser browser;
  private final SelectiveController controller;
  private final PathMotion motion;
  final World world;

  ControlledWorld(Path scene, CameraPath path, SelectiveController.Settings settings)
      throws IOException {
    ProblemCollector problems = new ProblemCollector();
    loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
    world = new World(loader.load(scene), problems);
    browser = new EmbeddedBrowser(world, loader, line -> {}, Map.of());
    controller = new SelectiveController(browser, settings, event -> {}, problem -> {});
    world.instances().update();
    motion = new PathMotion(path, 0);
  }

  void step(double time) {
    world.step(time, motion);
  }

  ObjectPlaces places() {
    return new ObjectPlaces(controller.choosable(), world.instances(), browser::nodeOf);
  }

  /** Returns the version of each object. */
  int[] choices() {
    return controller.choosable().stream().mapToInt(ChoosableObject::shown).toArray();
  }

  /** Shows versions of all objects in a step at the same time. */
  void show(int[] versions) {
    List<ChoosableObject> objects = controller.choosable();
    IntStream.range(0, versions.length)
        .forEach(i -> controller.choose(objects.get(i), versions[i], world.cascade().time()));
    step(world.time());
  }

  @Override
  public void close() {
    controller.close();
    browser.dispose();
    loader.close();
  }
}
