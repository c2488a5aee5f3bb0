package org.selectiverenderer.hmd;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.loading.SceneLoader;
import org.selectiverenderer.runtime.nodes.NodeFactory;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** Worlds of scenes written in a test. */
public final class TestWorlds {
  private TestWorlds() {}

  /** A world of these nodes, metres being its unit. */
  public static World world(String nodes) {
    return world("", nodes);
  }

  /**
   * A world.
   *
   * @param head what stands in the scene's head, such as a unit
   */
  public static World world(String head, String nodes) {
    String text =
        "<X3D version='4.0' profile='Full'><head>"
            + head
            + "</head><Scene>"
            + nodes
            + "</Scene></X3D>";
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      World world =
          new World(
              loader.load(
                  "test.x3d",
                  new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)),
                  Path.of("")),
              problems);
      world.step(0, (viewer, time, dt) -> {});
      if (problems.any()) {
        throw new IllegalArgumentException(problems.list().toString());
      }
      return world;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
