package org.selectiverenderer.app.figures;

import java.lang.management.ManagementFactory;
import java.util.Optional;
import org.selectiverenderer.runtime.render.Drawn;
import org.selectiverenderer.runtime.render.Shading;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.show.FrameTimes;
import org.selectiverenderer.tracker.LatencyMeter;

/** Collects the performance measurements of a run, frame by frame. */
public final class FigureKeeper {
  /** The number of frames whose times are kept for the percentiles: an hour at 60 per second. */
  private static final int KEPT = 216_000;

  private final long begun = System.nanoTime();
  private final FrameTimes times = new FrameTimes(KEPT);
  private PolygonCount polygons = PolygonCount.NONE;
  private PolygonCount drawn = PolygonCount.NONE;
  private double loadMs;
  private double firstFrameMs;
  private double processToFirstFrameMs;
  private long lastFrame;

  /** Reports that the scene is ready to be stepped. */
  public void loaded() {
    loadMs = since(begun);
  }

  /** Reports that a frame was drawn; the first frame is reported when the GPU has finished it. */
  public void frame(long scenePolygons, Drawn frame) {
    if (polygons.frames() == 0) {
      firstFrameMs = since(begun);
      processToFirstFrameMs =
          System.currentTimeMillis() - ManagementFactory.getRuntimeMXBean().getStartTime();
    } else {
      times.add(since(lastFrame));
    }
    lastFrame = System.nanoTime();
    polygons = polygons.with(scenePolygons);
    drawn = drawn.with(frame.triangles());
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
  public RunFigures figures(
      GlInfo gl,
      Shading shading,
      LatencyMeter latency,
      double trackerSilence,
      Optional<HeadsetFigures> headset) {
    return new RunFigures(
        loadMs,
        firstFrameMs,
        processToFirstFrameMs,
        times.summary(),
        polygons,
        drawn,
        ProcessMemory.peakMegabytes(),
        gl,
        shading,
        latency,
        trackerSilence,
        headset);
  }
}
