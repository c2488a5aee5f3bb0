package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * A scene whose files are read while it runs. The test is the stepping thread: what arrives in the
 * background waits in a queue for it.
 */
@Timeout(60)
abstract class RunningSceneLoaderTestCase {
  @TempDir Path folder;
  final BlockingQueue<Runnable> arrivals = new LinkedBlockingQueue<>();

  /** The hierarchies of large meshes that have arrived. */
  final Map<Mesh, MeshBvh> built = new IdentityHashMap<>();

  final ProblemCollector problems = new ProblemCollector();

  final EventCascade cascade = new EventCascade(problems);

  final SceneLoader loader =
      new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);

  LoadedScene loaded;

  RunningSceneLoader files;

  InstanceTree tree;

  @BeforeEach
  void writeScenes() throws IOException {
    for (int boxes = 1; boxes <= 4; boxes++) {
      write("boxes%d.x3d".formatted(boxes), "<Shape><Box/></Shape>".repeat(boxes));
    }
  }

  @AfterEach
  void close() {
    loader.close();
  }

  static String scene(String nodes) {
    return "<X3D version='4.0'><Scene>\n" + nodes + "</Scene></X3D>";
  }

  void write(String name, String nodes) throws IOException {
    Files.writeString(folder.resolve(name), scene(nodes));
  }

  void load(String nodes) throws IOException {
    byte[] text = scene(nodes).getBytes(StandardCharsets.UTF_8);
    loaded = loader.load("test.x3d", new ByteArrayInputStream(text), folder);
    files = new RunningSceneLoader(loaded, problems, arrivals::add, built::putAll);
    tree = new InstanceTree((GroupingNode) loaded.scene().root(), files.assets());
    watch();
    files.update();
  }

  void watch() {
    files.watch(
        loaded.scene().named().values().stream()
            .filter(InlineNode.class::isInstance)
            .map(InlineNode.class::cast)
            .toList());
  }

  Node node(String name) {
    return loaded.scene().find(name).orElseThrow();
  }

  void set(String name, String field, Object value) {
    cascade.send(node(name), node(name).type().indexOf(field), value);
    frame();
  }

  /** What a frame does: events are carried, the tree follows, files are asked for. */
  void frame() {
    cascade.run();
    tree.update();
    files.update();
  }

  void arrive() throws InterruptedException {
    arrivals.take().run();
    frame();
  }

  static String[] url(String... urls) {
    return urls;
  }

  void assertBoxes(int boxes) {
    assertThat(tree.shownPolygons()).isEqualTo(12L * boxes);
  }
}
