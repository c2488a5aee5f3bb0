package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.bench.HeavySceneGenerator;
import org.selectiverenderer.bench.ManySwitchesSceneGenerator;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * Prints how long the scenes of the benchmark take to load in a virtual machine just started, step
 * by step. Not a test. Arguments: a folder for the scene, {@code heavy} or {@code switches}, and
 * how many times in a row.
 */
final class SceneLoadingBenchmark {
  private SceneLoadingBenchmark() {}

  public static void main(String[] args) throws IOException {
    Path folder = Path.of(args[0]);
    if (Files.notExists(folder)) {
      if (args[1].equals("heavy")) {
        HeavySceneGenerator.write(folder, 1);
      } else {
        ManySwitchesSceneGenerator.write(folder, 100_000, 10);
      }
      return;
    }
    int rounds = args.length > 2 ? Integer.parseInt(args[2]) : 1;
    for (int round = 0; round < rounds; round++) {
      measure(folder.resolve("scene.x3d"));
    }
  }

  private static void measure(Path scene) throws IOException {
    long start = System.nanoTime();
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      long ready = System.nanoTime();
      LoadedScene loaded = loader.load(scene);
      long read = System.nanoTime();
      World world = new World(loaded, problems);
      long built = System.nanoTime();
      world.step(0, (viewer, time, dt) -> {});
      long stepped = System.nanoTime();
      Runtime runtime = Runtime.getRuntime();
      long taken = runtime.totalMemory() - runtime.freeMemory();
      System.gc();
      System.out.printf(
          Locale.ROOT,
          "catalogue %.0f ms, read and tessellated %.0f ms, built %.0f ms, first step %.0f ms, together"
              + " %.0f ms; %d polygons; heap %d MB, %d MB of it in use%n",
          (ready - start) * 1e-6,
          (read - ready) * 1e-6,
          (built - read) * 1e-6,
          (stepped - built) * 1e-6,
          (stepped - start) * 1e-6,
          world.instances().shownPolygons(),
          taken >> 20,
          (runtime.totalMemory() - runtime.freeMemory()) >> 20);
    }
  }
}
