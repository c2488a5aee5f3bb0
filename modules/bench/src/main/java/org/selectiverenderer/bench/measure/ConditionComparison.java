package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.decimal.DecimalRounding;

/**
 * Compares the conditions of an enriched scene: frames, the triangles that are drawn, and what
 * these cost alone. The conditions alternate, so that temporary load of the machine affects all of
 * them, and ratios are those of neighbouring runs.
 *
 * <p>{@code cpu_ms} is the processor time of a frame, over all threads: a software renderer's whole
 * work, which other load of the machine does not change. {@code vertex_ms} is that of a frame in a
 * picture with a 64th of the pixels: the work for vertices and triangles, whatever they cover.
 */
record ConditionComparison(ChildProcessRun child, int runs) {
  /** The condition with all polygons. */
  static final String HIGH = "high";

  /** The condition that shows what one does not expect with all polygons, the rest with few. */
  static final String SELECTIVE = "selective";

  private static final String CPU = "/frame_ms/processor";

  /** The runs of one condition: in a picture of the usual size, and in a small one. */
  record Runs(List<JsonNode> usual, List<JsonNode> small) {
    Runs() {
      this(new ArrayList<>(), new ArrayList<>());
    }
  }

  /**
   * Adds the figures of each condition, and the ratios.
   *
   * @param conditions among them {@link #HIGH} and {@link #SELECTIVE}
   * @param seconds duration in seconds of the path's time
   */
  void measure(Path scene, Path path, String seconds, List<String> conditions, ObjectNode node)
      throws IOException, InterruptedException {
    Map<String, Runs> figures = new LinkedHashMap<>();
    for (int run = 0; run < runs; run++) {
      for (String condition : conditions) {
        run(scene, path, seconds, condition, figures);
      }
    }
    put(node, figures);
  }

  /** Adds the figures of one condition alone. */
  void measure(Path scene, Path path, String seconds, String condition, ObjectNode node)
      throws IOException, InterruptedException {
    Map<String, Runs> figures = new LinkedHashMap<>();
    for (int run = 0; run < runs; run++) {
      run(scene, path, seconds, condition, figures);
    }
    figures.values().forEach(all -> figures(node, all));
  }

  private void run(
      Path scene, Path path, String seconds, String condition, Map<String, Runs> figures)
      throws IOException, InterruptedException {
    Runs all = figures.computeIfAbsent(condition, unused -> new Runs());
    all.usual().add(child.once(scene, path, seconds, "--condition", condition));
    all.small().add(child.small(scene, path, seconds, "--condition", condition));
  }

  static void put(ObjectNode node, Map<String, Runs> figures) {
    figures.forEach((condition, all) -> figures(node.putObject(condition), all));
    Runs selective = figures.get(SELECTIVE);
    Runs high = figures.get(HIGH);
    node.put("selective_to_high", ratio(selective.usual(), high.usual(), "/fps"));
    node.put("cpu_to_high", ratio(selective.usual(), high.usual(), CPU));
    node.put("vertex_to_high", ratio(selective.small(), high.small(), CPU));
  }

  private static void figures(ObjectNode node, Runs all) {
    node.put("first_frame_ms", ChildProcessRun.median(all.usual(), "/first_frame_ms"))
        .put("fps", ChildProcessRun.median(all.usual(), "/fps"))
        .put("frame_p50_ms", ChildProcessRun.median(all.usual(), "/frame_ms/p50"))
        .put("cpu_ms", ChildProcessRun.median(all.usual(), CPU))
        .put("vertex_ms", ChildProcessRun.median(all.small(), CPU))
        .put("polygons_drawn", ChildProcessRun.median(all.usual(), "/polygons_drawn/mean"))
        .put("polygons", ChildProcessRun.median(all.usual(), "/polygons/mean"))
        .put("rss_mb", ChildProcessRun.median(all.usual(), "/peak_rss_mb"));
  }

  /** Returns the median ratio of a figure of pairs of runs. */
  private static double ratio(List<JsonNode> ones, List<JsonNode> others, String key) {
    double[] ratios = new double[ones.size()];
    for (int i = 0; i < ratios.length; i++) {
      ratios[i] = ones.get(i).at(key).asDouble() / others.get(i).at(key).asDouble();
    }
    return DecimalRounding.to(2, Medians.median(ratios));
  }
}
