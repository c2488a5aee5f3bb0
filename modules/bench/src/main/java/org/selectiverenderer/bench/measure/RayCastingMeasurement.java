package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.ForkJoinPool;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.scene.RadiositySceneBuilder;
import org.selectiverenderer.radiosity.solve.MonteCarloFormFactors;
import org.selectiverenderer.radiosity.solve.SurfacePatches;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * Measures the ray casting of radiosity on one core: in the apartment, and over hills of growing
 * numbers of triangles, where the time of a ray should grow with their logarithm.
 */
final class RayCastingMeasurement {
  private static final int RAYS = 16;
  private static final int[] SIDES = {33, 129, 513};

  private RayCastingMeasurement() {}

  static void measure(Path apartment, Path folder, ObjectNode report)
      throws IOException, InterruptedException {
    try {
      RadiosityScene scene = read(apartment);
      report.put("triangles", scene.triangles().count());
      report.put("rays_per_s_per_core", raysPerSecond(scene, 0.3));
      ArrayNode growth = report.putArray("growth");
      for (int side : SIDES) {
        Path hills = folder.resolve("hills-" + side + ".x3d");
        Files.writeString(hills, hills(side));
        RadiosityScene some = read(hills);
        growth
            .addObject()
            .put("triangles", some.triangles().count())
            .put("rays_per_s_per_core", raysPerSecond(some, 0.5));
      }
    } catch (RadiosityException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private static RadiosityScene read(Path file) throws IOException, RadiosityException {
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      LoadedScene loaded = loader.load(file);
      InstanceTree tree = new InstanceTree((GroupingNode) loaded.scene().root(), loaded.assets());
      return new RadiositySceneBuilder(true, problems).read(tree, loaded.scene().unitLength());
    }
  }

  /** Returns the better of two runs, since the first one warms up. */
  private static long raysPerSecond(RadiosityScene scene, double patch) {
    SurfacePatches patches = new SurfacePatches(scene, patch);
    ForkJoinPool one = new ForkJoinPool(1);
    try {
      long best = 0;
      for (int run = 0; run < 2; run++) {
        long start = System.nanoTime();
        long rays =
            one.submit(
                    () ->
                        MonteCarloFormFactors.find(
                                scene, patches, RAYS, 2, 1, RadiosityProgress.NONE)
                            .cast())
                .join();
        best = Math.max(best, rays * 1_000_000_000L / (System.nanoTime() - start));
      }
      return best;
    } finally {
      one.shutdown();
    }
  }

  /**
   * Returns a scene with a hilly floor of 20 m by 20 m, two triangles per grid square, under a
   * lamp.
   */
  private static String hills(int side) {
    StringBuilder heights = new StringBuilder();
    for (int i = 0; i < side * side; i++) {
      double x = 20.0 * (i % side) / (side - 1);
      double z = 20.0 * (i / side) / (side - 1);
      heights.append(i == 0 ? "" : " ").append((float) (Math.sin(2 * x) * Math.cos(3 * z)));
    }
    return """
    <X3D profile='Immersive' version='3.3'><Scene><PointLight location='10 5 10'/>
    <Shape><Appearance><Material/></Appearance><ElevationGrid xDimension='%1$d' zDimension='%1$d'
    xSpacing='%2$s' zSpacing='%2$s' height='%3$s'/></Shape></Scene></X3D>
    """
        .formatted(side, 20.0 / (side - 1), heights);
  }
}
