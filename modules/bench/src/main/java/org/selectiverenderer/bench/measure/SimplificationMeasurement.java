package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.facts.PolygonCounts.Counts;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.models.simplify.Simplifier;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/**
 * Measures the polygon count process: the apartment's listed objects on all processors, and one
 * large mesh. Reading is not included, and the code is warm, because the process has generated the
 * apartment before.
 */
final class SimplificationMeasurement {
  /** Rings and steps of a waved torus: 2 * 707 * 708 = 1,001,112 triangles. */
  private static final int RINGS = 707;

  private static final int STEPS = 708;

  private final Simplifier simplifier = new Simplifier();

  private record Task(Model model, int polygons) {}

  /**
   * @param inlineNodes the folder of the apartment's objects
   */
  void measure(Path inlineNodes, ObjectNode node) throws IOException {
    Mesh large = torus();
    long begun = System.nanoTime();
    int left =
        simplifier
            .simplify(List.of(large), new SimplificationTarget.Polygons(large.polygons() / 10))
            .polygons();
    node.put("large_triangles", large.polygons());
    node.put("large_left", left);
    node.put("large_ms", DecimalRounding.to(1, (System.nanoTime() - begun) * 1e-6));
    List<Task> tasks = tasks(inlineNodes);
    begun = System.nanoTime();
    int polygons =
        tasks.parallelStream()
            .mapToInt(
                task ->
                    simplifier
                        .simplify(
                            task.model().meshes(),
                            new SimplificationTarget.Polygons(task.polygons()))
                        .polygons())
            .sum();
    node.put("objects", tasks.size());
    node.put("objects_left", polygons);
    node.put("objects_ms", DecimalRounding.to(1, (System.nanoTime() - begun) * 1e-6));
  }

  private static List<Task> tasks(Path inlineNodes) throws IOException {
    ModelReader reader = new ModelReader(NodeCatalogue.load());
    List<Task> tasks = new ArrayList<>();
    for (Counts counts : PolygonCounts.load().all().values()) {
      Path file = inlineNodes.resolve(counts.object() + "_v1.x3d");
      Model model =
          reader
              .read(file, new ProblemCollector())
              .orElseThrow(() -> new IOException("no model in " + file));
      tasks.add(new Task(model, counts.reduced()));
    }
    return tasks;
  }

  static Mesh torus() {
    float[] positions = new float[3 * RINGS * STEPS];
    int[] indices = new int[6 * RINGS * STEPS];
    for (int ring = 0; ring < RINGS; ring++) {
      double around = 2 * Math.PI * ring / RINGS;
      for (int step = 0; step < STEPS; step++) {
        double about = 2 * Math.PI * step / STEPS;
        double thick = 0.35 + 0.03 * Math.sin(9 * around) * Math.cos(7 * about);
        double radius = 1 + thick * Math.cos(about);
        int vertex = ring * STEPS + step;
        positions[3 * vertex] = (float) (radius * Math.cos(around));
        positions[3 * vertex + 1] = (float) (thick * Math.sin(about));
        positions[3 * vertex + 2] = (float) (radius * Math.sin(around));
        int right = (ring + 1) % RINGS * STEPS + step;
        int up = ring * STEPS + (step + 1) % STEPS;
        int both = (ring + 1) % RINGS * STEPS + (step + 1) % STEPS;
        int[] two = {vertex, up, right, right, up, both};
        System.arraycopy(two, 0, indices, 6 * vertex, 6);
      }
    }
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        positions,
        null,
        null,
        null,
        indices,
        true,
        Mesh.boundsOf(positions, indices));
  }
}
