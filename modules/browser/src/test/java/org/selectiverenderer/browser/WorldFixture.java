package org.selectiverenderer.browser;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** A world of nodes written in a test, and a log of what happens in it. */
final class WorldFixture implements AutoCloseable {
  private static final ViewerMotion STANDING = (viewer, time, dt) -> {};

  final List<String> log = new ArrayList<>();
  final ProblemCollector problems = new ProblemCollector();
  final SceneLoader loader =
      new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
  final World world;

  WorldFixture(String nodes) {
    this(Path.of("no-such-folder"), nodes);
  }

  /**
   * @param folder in which the scene counts as lying
   */
  WorldFixture(Path folder, String nodes) {
    world = new World(load(folder, nodes), problems);
    world.epoch(0); // So that tests may name the times of their frames.
  }

  LoadedScene load(Path folder, String nodes) {
    String text = "<X3D version='4.0' profile='Immersive'><Scene>\n" + nodes + "</Scene></X3D>";
    try {
      return loader.load(
          "test.x3d", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  Node node(String name) {
    return world.scene().find(name).orElseThrow();
  }

  Node make(String type) {
    return loader.factory().make(loader.catalogue().get(type), null, SourceLocation.of("test.x3d"));
  }

  void send(String node, String field, @Nullable Object value) {
    world.cascade().send(node(node), node(node).type().indexOf(field), value);
  }

  /** Logs the events of a field as {@code time node.field=value}. */
  void watch(String node, String field) {
    Node watched = node(node);
    watched.addListener(
        watched.type().indexOf(field),
        (from, index, value, time) ->
            log.add(String.format(Locale.ROOT, "%.2f %s.%s=%s", time, node, field, text(value))));
  }

  private static String text(@Nullable Object value) {
    return value instanceof float[] numbers ? Arrays.toString(numbers) : String.valueOf(value);
  }

  /** A frame in which the user does not move. */
  void step(double time) {
    world.step(time, STANDING);
  }

  /** A frame in which the user gets to a place. */
  void step(double time, double x, double y, double z) {
    world.step(time, (viewer, now, dt) -> viewer.moveTo(new Vector3d(x, y, z)));
  }

  @Override
  public void close() {
    loader.close();
  }
}
