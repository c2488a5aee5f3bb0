package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.browser.viewer.PathMotion;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/**
 * Measures a scene without drawing: the time from the start of reading until it can be stepped with
 * the controller, the heap that it occupies, the update of a frame along its path, and the frame in
 * which an area is entered or left.
 */
final class GrowthMeasurement {
  private static final double RATE = 60;

  /** The number of walks along the path, of which the last one is measured. */
  private static final int WALKS = 4;

  /** The number of measured entries and exits. */
  private static final int ROUNDS = 60;

  /** The timeout of a walk in seconds: a slow one must not take minutes. */
  private static final double PATIENCE = 3;

  private GrowthMeasurement() {}

  static void measure(BenchScene scene, int loads, ObjectNode row) throws IOException {
    double[] loadMs = new double[loads];
    double[] processorMs = new double[loads];
    for (int i = 0; i + 1 < loads; i++) {
      Stopwatch watch = new Stopwatch();
      Walkthrough walk = open(scene, new AtomicInteger());
      loadMs[i] = watch.milliseconds();
      processorMs[i] = watch.processorMilliseconds();
      walk.close();
    }
    double before = heapMegabytes();
    AtomicInteger changes = new AtomicInteger();
    Stopwatch watch = new Stopwatch();
    try (Walkthrough walk = open(scene, changes)) {
      loadMs[loads - 1] = watch.milliseconds();
      processorMs[loads - 1] = watch.processorMilliseconds();
      row.put("load_ms", DecimalRounding.to(1, Medians.median(loadMs)));
      row.put("load_cpu_ms", DecimalRounding.to(1, Medians.median(processorMs)));
      row.put("heap_mb", DecimalRounding.to(1, heapMegabytes() - before));
      row.put("enriched", scene.switches());
      row.put("polygons", walk.polygons());
      double end = walk(walk, scene, row);
      ObjectNode activation = row.putObject("activation");
      int told = changes.get();
      ActivationMeasurement.frames(walk, scene, end, ROUNDS, activation);
      // As many entries and exits warm up.
      activation.put("changed", Math.round((changes.get() - told) / (2.0 * ROUNDS)));
    }
  }

  /** Measures the elapsed time and the processor time of this process. */
  private static final class Stopwatch {
    private final long begun = System.nanoTime();
    private final long spent = processorNanos();

    double milliseconds() {
      return (System.nanoTime() - begun) * 1e-6;
    }

    double processorMilliseconds() {
      return (processorNanos() - spent) * 1e-6;
    }

    private static long processorNanos() {
      return ManagementFactory.getOperatingSystemMXBean()
              instanceof com.sun.management.OperatingSystemMXBean system
          ? system.getProcessCpuTime()
          : 0;
    }
  }

  /**
   * @param changes counts the changes of Switches
   */
  private static Walkthrough open(BenchScene scene, AtomicInteger changes) throws IOException {
    return Walkthrough.open(
        scene.scene(),
        SelectiveController.Settings.SELECTIVE,
        problem -> {},
        event -> {
          if (event instanceof TimelineEvent.ControllerEvent control
              && control.event() instanceof ControlEvent.SwitchChange) {
            changes.incrementAndGet();
          }
        },
        text -> {});
  }

  /** Returns the time of the last frame. */
  private static double walk(Walkthrough walk, BenchScene scene, ObjectNode row)
      throws IOException {
    Optional<CameraPath> path = CameraPathReader.read(scene.path(), new ProblemCollector());
    if (path.isEmpty()) {
      throw new IOException("the benchmark's path is broken");
    }
    int frames = (int) Math.round((path.get().end() - path.get().start()) * RATE);
    double[] us = new double[frames];
    double time = 0;
    int stepped = 0;
    for (int round = 0; round < WALKS; round++) {
      PathMotion motion = new PathMotion(path.get(), time - path.get().start());
      long start = System.nanoTime();
      stepped = 0;
      while (stepped < frames && System.nanoTime() - start < PATIENCE * 1e9) {
        time += 1 / RATE;
        long begun = System.nanoTime();
        walk.step(time, motion);
        us[stepped++] = (System.nanoTime() - begun) * 1e-3;
      }
    }
    double[] measured = Arrays.copyOf(us, stepped);
    Arrays.sort(measured);
    row.put("frame_us", DecimalRounding.to(1, Medians.median(measured)));
    row.put("frame_p99_us", DecimalRounding.to(1, measured[stepped * 99 / 100]));
    return time;
  }

  /** Returns the used heap after a garbage collection. */
  private static double heapMegabytes() {
    System.gc();
    return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed() / 1048576.0;
  }
}
