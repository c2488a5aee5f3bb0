package org.selectiverenderer.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.schema.VersionMetadata;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Microseconds to enter or leave an area whose schemas affect 10 of 100,000 enriched switches: the
 * decision alone, the frame with sensor, cascade, controller and instance tree, and a frame in
 * which nothing happens.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class ActivationBenchmark {
  private static final int SWITCHES = 100_000;
  private static final int AFFECTED = 10;
  private static final Vector3dc INSIDE = new Vector3d(0, 0, 0);
  private static final Vector3dc OUTSIDE = new Vector3d(0, 0, 6);

  private final SchemaActivation<String, Integer> activation = new SchemaActivation<>();
  private Path dir;
  private Walkthrough walk;
  private double time;
  private boolean inside;

  @Setup
  public void makeScene() throws IOException {
    activation.putArea("area", new SensorSchemas(List.of("Near"), List.of("Far")));
    for (int i = 0; i < SWITCHES; i++) {
      boolean affected = i % (SWITCHES / AFFECTED) == 0;
      activation.putSwitch(
          i, affected ? schemas("Near", "Far") : schemas("Near" + i % 1000, "Far" + i % 1000), 1);
    }
    dir = Files.createTempDirectory("activation");
    walk =
        Walkthrough.open(
            ManySwitchesSceneGenerator.write(dir, SWITCHES, AFFECTED).scene(),
            SelectiveController.Settings.SELECTIVE,
            problem -> {},
            event -> {},
            text -> {});
  }

  private static SwitchSchemas schemas(String first, String second) {
    return new SwitchSchemas(
        List.of(
            new VersionMetadata(0, Optional.empty(), Optional.empty(), List.of(first)),
            new VersionMetadata(1, Optional.empty(), Optional.empty(), List.of(second))));
  }

  @TearDown
  public void close() throws IOException {
    walk.close();
    try (Stream<Path> files = Files.walk(dir)) {
      files.sorted(Comparator.reverseOrder()).forEach(ActivationBenchmark::delete);
    }
  }

  private static void delete(Path file) {
    try {
      Files.delete(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Benchmark
  public List<SchemaActivation.Change<Integer>> activation() {
    inside = !inside;
    return inside ? activation.enter("area") : activation.exit("area");
  }

  @Benchmark
  public double frameThatSwitches() {
    inside = !inside;
    return step();
  }

  @Benchmark
  public double frameAtRest() {
    return step();
  }

  private double step() {
    time += 0.01;
    Vector3dc eye = inside ? INSIDE : OUTSIDE;
    walk.step(time, (viewer, now, dt) -> viewer.moveTo(eye));
    return time;
  }
}
