package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
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
  /** The duration of the drawn run in seconds of the path's time, in which 60 frames are drawn. */
  private static final String SECONDS_DRAWN = "1";

  /**
   * Measures the series.
   *
   * @throws IOException when a scene cannot be written or a run fails
   * @throws InterruptedException when the waiting thread is interrupted
   */
  public ObjectNode run(Set<GrowthSeries> wanted) throws IOException, InterruptedException {
    ObjectNode report = JsonTree.object();
    MachineDescription.describe(report.putObject("machine"));
    ObjectNode growth = report.putObject("growth");
    try (TemporaryFolder folder = new TemporaryFolder()) {
      warmUp(folder.path().resolve("warm-up"));
      for (GrowthSeries series : wanted) {
        String name = series.name().toLowerCase(Locale.ROOT);
        ArrayNode rows = growth.putArray(name);
        for (int size : series.sizes()) {
          progress.accept(String.format(Locale.ROOT, "%s: %,d", name, size));
          try (TemporaryFolder own = new TemporaryFolder()) {
            measure(series.write(own.path(), size), size, rows.addObject());
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

  private void measure(BenchScene scene, int size, ObjectNode row)
      throws IOException, InterruptedException {
    row.put("size", size);
    row.put("mb", DecimalRounding.to(2, scene.bytes() / 1e6));
    GrowthMeasurement.measure(scene, runs, row);
    if (draws) {
      JsonNode drawn =
          new ChildProcessRun(mainClass, 1).once(scene.scene(), scene.path(), SECONDS_DRAWN);
      row.put("fps", drawn.at("/fps").asDouble());
      row.put("first_frame_ms", drawn.at("/first_frame_ms").asDouble());
      row.put("rss_mb", drawn.at("/peak_rss_mb").asDouble());
    }
  }
}
