package org.selectiverenderer.app.metrics;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.display.FrameTimeStatistics;
import org.selectiverenderer.tracker.LatencyHistogram;

/** Collects the performance measurements of a run, frame by frame. */
public final class RunMetricsCollector {
  /** The number of frames whose times are kept for the percentiles: an hour at 60 per second. */
  private static final int KEPT = 216_000;

  /** The number of frames before processor time counts, in which code is compiled and sent. */
  private static final int WARM_UP = 60;

  private final long begun = System.nanoTime();
  private final FrameTimeStatistics times = new FrameTimeStatistics(KEPT);
  private FramePolygonStatistics polygons = FramePolygonStatistics.NONE;
  private FramePolygonStatistics drawn = FramePolygonStatistics.NONE;
  private long warmProcessorNanos;
  private long lastProcessorNanos;
  private double loadMs;
  private double firstFrameMs;
  private double processToFirstFrameMs;
  private long lastFrame;

  /** Reports that the scene is ready to be stepped. */
  public void loaded() {
    loadMs = since(begun);
  }

  /** Reports that a frame was drawn; the first frame is reported when the GPU has finished it. */
  public void frame(long scenePolygons, FrameStatistics frame) {
    if (polygons.frames() == 0) {
      firstFrameMs = since(begun);
      processToFirstFrameMs =
          System.currentTimeMillis() - ManagementFactory.getRuntimeMXBean().getStartTime();
    } else {
      times.add(since(lastFrame));
    }
    lastFrame = System.nanoTime();
    lastProcessorNanos = processorNanos();
    if (polygons.frames() == WARM_UP) {
      warmProcessorNanos = lastProcessorNanos;
    }
    polygons = polygons.with(scenePolygons);
    drawn = drawn.with(frame.triangles());
  }

  /** Returns the processor time of all threads of this process, 0 if unknown. */
  private static long processorNanos() {
    return ManagementFactory.getOperatingSystemMXBean()
            instanceof com.sun.management.OperatingSystemMXBean system
        ? system.getProcessCpuTime()
        : 0;
  }

  private double processorMs() {
    long frames = polygons.frames() - 1 - WARM_UP;
    return frames > 0 ? (lastProcessorNanos - warmProcessorNanos) * 1e-6 / frames : 0;
  }

  private static double since(long nanos) {
    return (System.nanoTime() - nanos) * 1e-6;
  }

  /**
   * Returns the measurements so far.
   *
   * @param trackerSilence the longest time without a tracker's record, in seconds
   * @param headset the measurements of the headset in which the run is shown, if any
   */
  public RunMetrics figures(
      GlInfo gl,
      ShadingMode shading,
      LatencyHistogram latency,
      double trackerSilence,
      Optional<HeadsetMetrics> headset) {
    return new RunMetrics(
        loadMs,
        firstFrameMs,
        processToFirstFrameMs,
        times.summary(),
        processorMs(),
        polygons,
        drawn,
        ProcessMemory.peakMegabytes(),
        gl,
        shading,
        latency,
        trackerSilence,
        headset,
        Optional.empty());
  }

  /** Reads the memory use of this process. */
  private static final class ProcessMemory {
    private static final Path STATUS = Path.of("/proc/self/status");

    private ProcessMemory() {}

    /**
     * Returns the peak resident set size of this process in MiB. Where the operating system does
     * not report it (Linux does), returns the memory committed by the Java virtual machine.
     */
    static double peakMegabytes() {
      return linux("VmHWM:").orElseGet(ProcessMemory::committed);
    }

    private static Optional<Double> linux(String key) {
      // On Windows the path would be one of the current drive, where anybody's file may lie.
      if (!System.getProperty("os.name", "").equals("Linux") || !Files.isReadable(STATUS)) {
        return Optional.empty();
      }
      List<String> lines;
      try {
        lines = Files.readAllLines(STATUS);
      } catch (IOException e) {
        return Optional.empty();
      }
      return lines.stream()
          .filter(line -> line.startsWith(key))
          .findFirst()
          .map(line -> line.replaceAll("[^0-9]", ""))
          .map(kilobytes -> Long.parseLong(kilobytes) / 1024.0);
    }

    private static double committed() {
      MemoryMXBean memory = ManagementFactory.getMemoryMXBean();
      long bytes =
          memory.getHeapMemoryUsage().getCommitted()
              + memory.getNonHeapMemoryUsage().getCommitted();
      return bytes / 1024.0 / 1024.0;
    }
  }
}
