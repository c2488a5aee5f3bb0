package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.base.platform.ParentProcessWatcher;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.formats.json.JsonTree;

/**
 * Runs a scene off-screen in a child process, with the Java, class path and flags of this process,
 * and reads its measurements.
 *
 * @param mainClass main class of the command line
 */
record ChildProcessRun(String mainClass, int runs) {
  /** Width and height of the picture, the same as for other browsers. */
  private static final String SIZE = "1024x768";

  /** A picture of the same shape with a 64th of the pixels: what is left is the triangles' time. */
  private static final String SMALL = "128x96";

  /** The duration of the run in seconds of the path's time: 300 frames. */
  private static final String SECONDS = "5";

  /** The system property with the launcher's JVM flags for {@code run}, separated by commas. */
  private static final String FLAGS = "selective-renderer.run-flags";

  /** The medians over the runs. */
  record Result(
      double loadMs, double startMs, double fps, double p50, double p99, double rss, JsonNode gl) {}

  Result run(BenchScene scene) throws IOException, InterruptedException {
    List<JsonNode> all = new ArrayList<>();
    for (int i = 0; i < runs; i++) {
      all.add(once(scene.scene(), scene.path(), SECONDS));
    }
    return new Result(
        median(all, "/first_frame_ms"),
        median(all, "/process_to_first_frame_ms"),
        median(all, "/fps"),
        median(all, "/frame_ms/p50"),
        median(all, "/frame_ms/p99"),
        median(all, "/peak_rss_mb"),
        all.get(0).get("gl"));
  }

  static double median(List<JsonNode> all, String key) {
    return Medians.median(all.stream().mapToDouble(node -> node.at(key).asDouble()).toArray());
  }

  /**
   * Returns the measurements of one run along a path.
   *
   * @param seconds duration in seconds of the path's time
   * @param more options of {@code run}
   */
  JsonNode once(Path scene, Path path, String seconds, String... more)
      throws IOException, InterruptedException {
    return once(SIZE, scene, path, seconds, more);
  }

  /** Returns the measurements of the same in a very small picture. */
  JsonNode small(Path scene, Path path, String seconds, String... more)
      throws IOException, InterruptedException {
    return once(SMALL, scene, path, seconds, more);
  }

  private JsonNode once(String size, Path scene, Path path, String seconds, String... more)
      throws IOException, InterruptedException {
    List<String> options = new ArrayList<>(List.of("--size", size, "--samples", "0"));
    options.addAll(List.of("--path", path.toString(), "--duration", seconds));
    options.addAll(List.of(more));
    return once(scene, options);
  }

  /** Returns the measurements of one run with options of {@code run}. */
  JsonNode once(Path scene, List<String> options) throws IOException, InterruptedException {
    Path stats = Files.createTempFile("selective-renderer-bench", ".json");
    Path log = Files.createTempFile("selective-renderer-bench", ".log");
    try {
      Process process =
          new ProcessBuilder(command(scene, options, stats))
              .redirectErrorStream(true)
              .redirectOutput(log.toFile())
              .start();
      try {
        if (process.waitFor() != 0) {
          throw new IOException(
              "running %s failed: %s"
                  .formatted(scene, Files.readString(log, StandardCharsets.UTF_8).strip()));
        }
      } finally {
        process.destroyForcibly(); // The measurement may be interrupted, as by Ctrl-C.
      }
      return JsonTree.read(stats);
    } finally {
      Files.deleteIfExists(stats);
      Files.deleteIfExists(log);
    }
  }

  private List<String> command(Path scene, List<String> options, Path stats) {
    List<String> arguments = new ArrayList<>(List.of("run", scene.toString(), "--offscreen"));
    arguments.addAll(options);
    arguments.addAll(List.of("--stats", stats.toString()));
    List<String> own = new ArrayList<>(List.of(ParentProcessWatcher.flag()));
    String flags = System.getProperty(FLAGS, "");
    own.addAll(flags.isEmpty() ? List.of() : List.of(flags.split(",")));
    return ChildProcessCommand.of(mainClass, own, arguments);
  }
}
