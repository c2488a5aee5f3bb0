package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.bench.GrowthSeries;
import org.selectiverenderer.formats.json.JsonTree;

/**
 * Measures how loading, memory and frame times grow with the size of a scene, for each {@link
 * GrowthSeries} from its smallest scene to its largest. The time to load should grow no faster than
 * the scene, and the update of a frame not at all.
 *
 * @param mainClass main class of the command line, started as a new process to draw each scene
 * @param draws whether frames are drawn too, which needs a display with OpenGL
 * @param runs number of times that each scene is loaded; the median is reported
 * @param progress receives messages about the progress
 */
public record GrowthBenchmark(
    String mainClass, boolean draws, int runs, Consumer<String> progress) {
  /** The share of the largest heap that a scene may need to be measured. */
  private static final double HEAP_SHARE = 0.8;

  /**
   * Measures the series.
   *
   * @param largest whether sizes are measured that take minutes and gigabytes
   * @throws IOException when a scene cannot be written or read
   * @throws InterruptedException when the waiting thread is interrupted
   */
  public ObjectNode run(Set<GrowthSeries> wanted, boolean largest)
      throws IOException, InterruptedException {
    ObjectNode report = JsonTree.object();
    MachineDescription.describe(report.putObject("machine"));
    ObjectNode growth = report.putObject("growth");
    try (TemporaryFolder folder = new TemporaryFolder()) {
      warmUp(folder.path().resolve("warm-up"));
    }
    for (GrowthSeries series : wanted) {
      ArrayNode rows = growth.putArray(name(series));
      try (TemporaryFolder common = new TemporaryFolder()) {
        for (int size : largest ? series.sizes() : series.usualSizes()) {
          progress.accept(String.format(Locale.ROOT, "%s: %,d", name(series), size));
          Optional<String> reason = tooLarge(rows, size, Runtime.getRuntime().maxMemory());
          if (reason.isPresent()) {
            progress.accept("not measured: " + reason.get());
            rows.addObject().put("size", size).put("skipped", reason.get());
          } else if (series.sharesFiles()) {
            measure(series, common.path(), size, rows.addObject());
          } else {
            try (TemporaryFolder own = new TemporaryFolder()) {
              measure(series, own.path(), size, rows.addObject());
            }
          }
        }
      }
    }
    return report;
  }

  /** Warms up the JVM, so that the first and smallest scenes are not measured cold. */
  private static void warmUp(Path folder) throws IOException {
    BenchScene scene = GrowthSeries.INLINES.write(folder, GrowthSeries.INLINES.sizes().get(0));
    for (int round = 0; round < 5; round++) {
      GrowthMeasurement.measure(scene, 1, JsonTree.object());
    }
  }

  private static String name(GrowthSeries series) {
    return series.name().toLowerCase(Locale.ROOT);
  }

  /**
   * Tells why a scene is not measured: if its heap grows from that of the two smaller ones before
   * it as their heap grew, it does not fit.
   *
   * @param rows those of the smaller scenes, ascending
   * @param most the largest heap in bytes
   */
  static Optional<String> tooLarge(ArrayNode rows, int size, long most) {
    List<JsonNode> measured = rows.valueStream().filter(row -> row.has("heap_mb")).toList();
    if (measured.size() < rows.size()) {
      return Optional.of("a smaller one was too large");
    }
    if (measured.size() < 2) {
      return Optional.empty();
    }
    JsonNode last = measured.get(measured.size() - 1);
    JsonNode before = measured.get(measured.size() - 2);
    double slope =
        (last.get("heap_mb").asDouble() - before.get("heap_mb").asDouble())
            / (last.get("size").asInt() - before.get("size").asInt());
    double needed = last.get("heap_mb").asDouble() + slope * (size - last.get("size").asInt());
    double available = HEAP_SHARE * most / (1 << 20);
    return needed <= available
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "it takes about %,.0f MB of Java's heap, of which %,.0f MB are available here"
                    + " (SELECTIVE_RENDERER_JAVA_OPTS=-Xmx... gives more)",
                needed,
                available));
  }

  private void measure(GrowthSeries series, Path folder, int size, ObjectNode row)
      throws IOException, InterruptedException {
    BenchScene scene = series.write(folder, size);
    row.put("size", size);
    row.put("mb", DecimalRounding.to(2, scene.bytes() / 1e6));
    GrowthMeasurement.measure(scene, runs, row);
    if (draws) {
      draw(scene, series.secondsDrawn(), row);
    }
  }

  private void draw(BenchScene scene, int seconds, ObjectNode row) throws InterruptedException {
    try {
      JsonNode drawn =
          new ChildProcessRun(mainClass, 1)
              .once(scene.scene(), scene.path(), Integer.toString(seconds));
      row.put("fps", drawn.at("/fps").asDouble());
      row.put("frame_p50_ms", drawn.at("/frame_ms/p50").asDouble());
      row.put("frame_p95_ms", drawn.at("/frame_ms/p95").asDouble());
      row.put("loaded_ms", drawn.at("/load_ms").asDouble());
      row.put("first_frame_ms", drawn.at("/first_frame_ms").asDouble());
      row.put("polygons_drawn", drawn.at("/polygons_drawn/mean").asDouble());
      row.put("rss_mb", drawn.at("/peak_rss_mb").asDouble());
    } catch (IOException e) {
      // Too large for the memory, say: what was measured until then is not lost for it.
      String reason = String.valueOf(e.getMessage()).lines().findFirst().orElse("");
      progress.accept("not drawn: " + reason);
      row.put("undrawn", reason);
    }
  }
}
