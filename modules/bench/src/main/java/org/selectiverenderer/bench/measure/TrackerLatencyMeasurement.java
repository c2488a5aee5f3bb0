package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.tracker.emulator.EmulatedInterTrax2;
import org.selectiverenderer.tracker.emulator.HeadMotion;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator;

/**
 * Measures the latency from the arrival of a tracker sample to the submitted frame that shows it,
 * with both eyes drawn: an emulated InterTrax2 on a pseudo-terminal, at its usual rate and at the
 * highest rate of its serial line.
 */
final class TrackerLatencyMeasurement {
  private static final int[] RATES = {120, 240, 480};
  private static final String SECONDS = "5";

  private TrackerLatencyMeasurement() {}

  static void measure(BenchScene scene, Path folder, ChildProcessRun child, ArrayNode rows)
      throws IOException, InterruptedException {
    for (int rate : RATES) {
      Path link = folder.resolve("intertrax2-" + rate);
      ObjectNode row = rows.addObject().put("rate_hz", rate);
      try (EmulatedInterTrax2 device =
          EmulatedInterTrax2.start(
              link, new InterTrax2Emulator.Settings(rate, HeadMotion.LOOKING_ABOUT))) {
        JsonNode stats =
            child.once(
                scene.scene(),
                List.of(
                    "--display",
                    "side-by-side",
                    "--samples",
                    "0",
                    "--duration",
                    SECONDS,
                    "--tracker",
                    "intertrax2:" + device.link()));
        row.put("records", stats.at("/latency_ms/records").asLong());
        row.put("p50_ms", stats.at("/latency_ms/p50").asDouble());
        row.put("p99_ms", stats.at("/latency_ms/p99").asDouble());
        row.put("max_ms", stats.at("/latency_ms/max").asDouble());
        row.put("frame_p50_ms", stats.at("/frame_ms/p50").asDouble());
        row.put("frame_p99_ms", stats.at("/frame_ms/p99").asDouble());
      } catch (IOException e) {
        row.put("skipped", e.getMessage());
      }
    }
  }
}
