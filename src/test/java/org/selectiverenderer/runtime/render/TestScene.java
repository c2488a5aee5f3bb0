package org.selectiverenderer.runtime.render;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.loading.SceneLoader;
import org.selectiverenderer.runtime.nodes.NodeFactory;
import org.selectiverenderer.runtime.nodes.group.GroupingNode;
import org.selectiverenderer.runtime.scene.EventCascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** A scene written in a test, or read from a file, with its instance tree. */
public record TestScene(LoadedScene loaded, InstanceTree tree, EventCascade cascade) {

  /** The scene with these nodes, in X3D's XML encoding. */
  public static TestScene of(String nodes) {
    return of("4.0", nodes);
  }

  /** Likewise, in a version of X3D. */
  public static TestScene of(String version, String nodes) {
    String text =
        "<X3D profile='Full' version='%s'><Scene>%s</Scene></X3D>".formatted(version, nodes);
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader = loader(problems)) {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      TestScene scene =
          of(loader.load("test.x3d", new ByteArrayInputStream(bytes), Path.of("")), problems);
      if (problems.any()) {
        throw new IllegalArgumentException(problems.list().toString());
      }
      return scene;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  public static TestScene load(Path file) {
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader = loader(problems)) {
      return of(loader.load(file), problems);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static SceneLoader loader(ProblemCollector problems) {
    return new SceneLoader(
        NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
  }

  private static TestScene of(LoadedScene loaded, ProblemCollector problems) {
    GroupingNode root = (GroupingNode) loaded.scene().root();
    return new TestScene(
        loaded, new InstanceTree(root, loaded.assets()), new EventCascade(problems));
  }

  /** Sends an event and lets the tree follow. */
  public void set(String def, String field, Object value) {
    Node node = loaded.scene().find(def).orElseThrow();
    cascade.send(node, node.type().indexOf(field), value);
    cascade.run();
    tree.update();
  }
}
