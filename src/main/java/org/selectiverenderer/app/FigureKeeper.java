package org.selectiverenderer.app;

import java.lang.management.ManagementFactory;
import org.selectiverenderer.runtime.render.Drawn;
import org.selectiverenderer.runtime.render.FrameTimes;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.tracker.LatencyMeter;

/** Collects the figures of a run, frame by frame. */
final class FigureKeeper {
  /** Frames whose times are kept for the percentiles: an hour at 60 per second. */
  private static final int KEPT = 216_000;

  private final long begun = System.nanoTime();
  private final FrameTimes times = new FrameTimes(KEPT);
  private PolygonCount polygons = PolygonCount.NONE;
  private PolygonCount drawn = PolygonCount.NONE;
  private double loadMs;
  private double firstFrameMs;
  private double processToFirstFrameMs;
  private long lastFrame;

  /** The scene is ready to be stepped. */
  void loaded() {
    loadMs = since(begun);
  }

  /** The first frame is completely drawn. */
  void firstFrame(long scenePolygons, Drawn frame) {
    firstFrameMs = since(begun);
    processToFirstFrameMs =
        System.currentTimeMillis() - ManagementFactory.getRuntimeMXBean().getStartTime();
    count(scenePolygons, frame);
  }

  /** A later frame is drawn. */
  void frame(long scenePolygons, Drawn frame) {
    times.add(since(lastFrame));
    count(scenePolygons, frame);
  }

  private void count(long scenePolygons, Drawn frame) {
    lastFrame = System.nanoTime();
    polygons = polygons.with(scenePolygons);
    drawn = drawn.with(frame.triangles());
  }

  private static double since(long nanos) {
    return (System.nanoTime() - nanos) * 1e-6;
  }

  RunFigures figures(GlInfo gl, LatencyMeter latency) {
    return new RunFigures(
        loadMs,
        firstFrameMs,
        processToFirstFrameMs,
        times.summary(),
        polygons,
        drawn,
        ProcessMemory.peakMegabytes(),
        gl,
        latency);
  }
}
