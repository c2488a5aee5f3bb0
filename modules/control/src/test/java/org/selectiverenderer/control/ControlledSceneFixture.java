package org.selectiverenderer.control;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.sai.EmbeddedBrowser;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.grouping.Switch;

/** A scene written in a test, in the embedded browser, under the controller. */
final class ControlledSceneFixture implements AutoCloseable {
  final World world;
  final EmbeddedBrowser browser;
  final List<ControlEvent> events = new ArrayList<>();
  final List<ControlProblem> problems = new ArrayList<>();
  SelectiveController controller;
  private final Path folder;
  private final SceneLoader loader;
  private double time;

  /** The scene without a controller; see {@link #control}. */
  ControlledSceneFixture(String nodes) {
    this(Path.of(""), nodes);
  }

  /** The scene in a folder, whose files it may inline. */
  ControlledSceneFixture(Path folder, String nodes) {
    this.folder = folder;
    ProblemCollector found = new ProblemCollector();
    loader = new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), found);
    world = new World(load(nodes), found);
    world.epoch(0); // So that tests may name the times of their frames.
    browser = new EmbeddedBrowser(world, loader, line -> {}, Map.of());
  }

  static ControlledSceneFixture under(Condition condition, String nodes) {
    ControlledSceneFixture scene = new ControlledSceneFixture(nodes);
    scene.control(condition);
    return scene;
  }

  void control(Condition condition) {
    control(new Settings(condition, 7));
  }

  void control(Settings settings) {
    controller = new SelectiveController(browser, settings, events::add, problems::add);
  }

  void control(Settings settings, SwitchTiming timing) {
    controller = new SelectiveController(browser, settings, timing, events::add, problems::add);
  }

  Set<String> hold(Map<String, Integer> choices) {
    return controller.hold(choices);
  }

  private LoadedScene load(String nodes) {
    byte[] text = file(nodes).getBytes(StandardCharsets.UTF_8);
    try {
      return loader.load("test.x3d", new ByteArrayInputStream(text), folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A whole file around some nodes. */
  static String file(String nodes) {
    return "<X3D version='4.0' profile='Full'><Scene>" + nodes + "</Scene></X3D>";
  }

  /** A ProximitySensor as in Fig 77: a box of 2 m around (x, 0, 0). */
  static String area(String name, double x, String enter, String exit) {
    return "<Transform translation='%s 0 0'><ProximitySensor DEF='%s' size='2 2 2'>"
            .formatted(x, name)
        + "<MetadataSet containerField='metadata'>"
        + "<MetadataString name='enterTimeSchema' value='\"%s\"'/>".formatted(enter)
        + "<MetadataString name='exitTimeSchema' value='\"%s\"'/>".formatted(exit)
        + "</MetadataSet></ProximitySensor></Transform>";
  }

  /** A Switch as in Fig 78: child 0 for one schema, low; child 1 for another, high. */
  static String object(String def, String lowSchema, String highSchema) {
    return "<Switch %s whichChoice='1'><Group/><Group/>".formatted(def)
        + "<MetadataSet containerField='metadata'>"
        + choice("low", lowSchema)
        + choice("high", highSchema)
        + "</MetadataSet></Switch>";
  }

  private static String choice(String degree, String schema) {
    return "<MetadataSet><MetadataString name='consistencyType' value='\"consistent\"'/>"
        + "<MetadataString name='degreeOfConsistency' value='\"%s\"'/>".formatted(degree)
        + "<MetadataString name='schemaBelonginess' value='\"%s\"'/>".formatted(schema)
        + "</MetadataSet>";
  }

  /** One frame, one second after the last, with the viewer at (x, 0, 0). */
  void walkTo(double x) {
    time++;
    world.step(time, (viewer, now, dt) -> viewer.moveTo(new Vector3d(x, 0, 0)));
  }

  X3DScene scene() {
    return (X3DScene) browser.getExecutionContext();
  }

  X3DNode node(String name) {
    return scene().getNamedNode(name);
  }

  int choice(String name) {
    return ((Switch) node(name)).getWhichChoice();
  }

  /** The events since the last call. */
  List<ControlEvent> news() {
    List<ControlEvent> news = List.copyOf(events);
    events.clear();
    return news;
  }

  @Override
  public void close() {
    if (controller != null) {
      controller.close();
    }
    browser.dispose();
    loader.close();
  }
}
