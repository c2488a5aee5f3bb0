package org.selectiverenderer.browser.sai;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;

/** An embedded browser whose world the test steps. */
final class SaiFixture implements AutoCloseable {
  final NodeCatalogue catalogue = NodeCatalogue.load();
  final ProblemCollector problems = new ProblemCollector();
  final List<String> printed = new ArrayList<>();
  final World world;
  final EmbeddedBrowser browser;
  private final SceneLoader loader;
  private double time;

  SaiFixture() {
    loader = new SceneLoader(catalogue, new NodeFactory(), ReadLimits.standard(), problems);
    Node root = loader.factory().make(catalogue.get("Group"), null, SourceLocation.of("(empty)"));
    Scene empty = new Scene(root, "", "4.0", "Full", Map.of(), 1);
    world = new World(new LoadedScene(empty, loader), problems);
    world.epoch(0); // So that tests may name the times of their frames.
    browser = new EmbeddedBrowser(world, loader, printed::add, Map.of("Antialiased", true));
  }

  /** A browser that shows some nodes. */
  static SaiFixture showing(String nodes) {
    SaiFixture sai = new SaiFixture();
    sai.browser.replaceWorld(sai.browser.createX3DFromString(file(nodes)));
    return sai;
  }

  static String file(String nodes) {
    return "<X3D version='4.0' profile='Immersive'><Scene>" + nodes + "</Scene></X3D>";
  }

  X3DScene scene() {
    return (X3DScene) browser.getExecutionContext();
  }

  X3DNode node(String name) {
    return scene().getNamedNode(name);
  }

  <T> T node(String name, Class<T> type) {
    return type.cast(node(name));
  }

  /** A new node, not realized. */
  X3DNode make(String type) {
    return scene().createNode(type);
  }

  /** One frame, one second after the last; the first is at 1. */
  void step() {
    world.step(++time, (viewer, now, dt) -> {});
  }

  /** One frame with the viewer at (x, 0, 0). */
  void walkTo(double x) {
    world.step(++time, (viewer, now, dt) -> viewer.moveTo(new Vector3d(x, 0, 0)));
  }

  List<String> complaints() {
    return problems.list().stream().map(Problem::message).toList();
  }

  @Override
  public void close() {
    browser.dispose();
    loader.close();
  }
}
