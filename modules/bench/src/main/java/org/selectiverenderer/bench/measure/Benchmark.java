package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.selectiverenderer.apartment.ApartmentGenerator;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.bench.HeavySceneGenerator;
import org.selectiverenderer.bench.ManySwitchesSceneGenerator;
import org.selectiverenderer.bench.VersionsSceneGenerator;
import org.selectiverenderer.formats.json.JsonTree;

/**
 * Runs the benchmark of this machine. Its files are written to a temporary folder and deleted
 * afterwards.
 *
 * @param mainClass main class of the command line, started as a new process for each run of a scene
 * @param runs number of runs of each scene, of which the median is reported
 * @param progress receives messages about the progress
 */
public record Benchmark(String mainClass, int runs, Consumer<String> progress) {
  private static final int SWITCHES = 100_000;
  private static final int AFFECTED = 10;

  /** The share of triangles with which objects cost next to nothing. */
  private static final double BARE = 0.01;

  /** The duration of a run in each condition in seconds of the path's time, the whole way round. */
  private static final String SECONDS = "20";

  /**
   * Runs all measurements.
   *
   * @throws IOException when a scene cannot be written or a run fails
   * @throws InterruptedException when the waiting thread is interrupted
   */
  public ObjectNode run() throws IOException, InterruptedException {
    try (TemporaryFolder folder = new TemporaryFolder()) {
      return measure(folder.path());
    }
  }

  private ObjectNode measure(Path folder) throws IOException, InterruptedException {
    ObjectNode report = JsonTree.object();
    MachineDescription.describe(report.putObject("machine"));
    ObjectNode gl = report.putObject("gl");
    progress.accept("writing scenes");
    BenchScene heavy = HeavySceneGenerator.heavy(folder);
    BenchScene light = HeavySceneGenerator.light(folder);
    BenchScene many = ManySwitchesSceneGenerator.write(folder.resolve("many"), SWITCHES, AFFECTED);
    progress.accept("reading");
    ReadingMeasurement.measure(folder.resolve("heavy"), report.putObject("read"));
    ChildProcessRun child = new ChildProcessRun(mainClass, runs);
    progress.accept("heavy scene: 784,000 triangles");
    ChildProcessRun.Result result = child.run(heavy);
    gl.setAll((ObjectNode) result.gl());
    ObjectNode heavyNode = report.putObject("heavy");
    put(heavyNode, heavy, result);
    RawDrawMeasurement.measure(heavy, heavyNode);
    progress.accept("light scene: a sixth of it");
    ObjectNode lightNode = report.putObject("light");
    put(lightNode, light, child.run(light));
    RawDrawMeasurement.measure(light, lightNode);
    progress.accept("the heavy scene with versions: high and selective");
    ConditionComparison conditions = new ConditionComparison(child, runs);
    BenchScene versions = VersionsSceneGenerator.write(folder.resolve("versions"), 1);
    conditions.measure(
        versions.scene(),
        versions.path(),
        SECONDS,
        List.of(ConditionComparison.HIGH, ConditionComparison.SELECTIVE),
        report.putObject("versions"));
    BenchScene bare = VersionsSceneGenerator.write(folder.resolve("bare"), BARE);
    conditions.measure(
        bare.scene(),
        bare.path(),
        SECONDS,
        ConditionComparison.HIGH,
        ((ObjectNode) report.get("versions")).putObject("bare"));
    progress.accept("both eyes");
    ObjectNode stereo = report.putObject("stereo");
    StereoMeasurement.measure(heavy, DisplayProfile.PROVIEW_50, stereo.putObject("heavy"));
    StereoMeasurement.measure(light, DisplayProfile.PROVIEW_50, stereo.putObject("light"));
    progress.accept("head tracker's record to picture");
    TrackerLatencyMeasurement.measure(light, folder, child, report.putArray("tracker_latency"));
    progress.accept("activation among 100,000 switches");
    ActivationMeasurement.measure(many, AFFECTED, report.putObject("activation"));
    progress.accept("apartment: writing it");
    Path apartment = folder.resolve("apartment");
    new ApartmentGenerator().writeAll(apartment, false);
    progress.accept("polygon count process");
    new SimplificationMeasurement()
        .measure(apartment.resolve("inlineNodes"), report.putObject("simplify"));
    progress.accept("radiosity: rays");
    RayCastingMeasurement.measure(
        apartment.resolve("scenes").resolve("apartment-unlit.x3d"),
        folder,
        report.putObject("radiosity"));
    new RoomMeasurement(conditions, progress)
        .measure(
            apartment.resolve("scenes").resolve("apartment.x3d"),
            apartment,
            report.putObject("apartment"));
    return report;
  }

  private static void put(ObjectNode node, BenchScene scene, ChildProcessRun.Result result) {
    node.put("triangles", scene.triangles());
    node.put("load_ms", result.loadMs());
    node.put("process_to_first_frame_ms", result.startMs());
    node.put("fps", result.fps());
    node.put("frame_p50_ms", result.p50());
    node.put("frame_p99_ms", result.p99());
    node.put("rss_mb", result.rss());
  }
}
