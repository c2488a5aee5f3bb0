package org.selectiverenderer.app.metrics;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.display.FrameTimeStatistics;
import org.selectiverenderer.render.window.DisplayTiming;
import org.selectiverenderer.tracker.LatencyHistogram;

/**
 * The performance measurements of a run.
 *
 * @param loadMs milliseconds from the start of reading until the scene is ready to be stepped
 * @param firstFrameMs milliseconds from the start of reading until the first frame is completely
 *     drawn
 * @param processToFirstFrameMs milliseconds from the start of the process until the first frame is
 *     completely drawn
 * @param times statistics of the intervals between consecutive frames
 * @param processorMs milliseconds of processor time per frame, over all threads, once warm; 0 if
 *     the run is too short or the platform does not tell
 * @param polygons polygons of the whole scene with its current versions, visible or not, per frame
 * @param drawn triangles sent to the GPU after culling, per frame and for all eyes
 * @param shading the shading that was asked for
 * @param latency time from the arrival of a tracker sample until the frame that shows it is
 *     submitted
 * @param trackerSilence the longest time without a tracker sample, in seconds; 0 without a tracker
 * @param headset the measurements of the headset in which the run was shown, if any
 * @param display how the frames of the window were paced, if there was one
 */
public record RunMetrics(
    double loadMs,
    double firstFrameMs,
    double processToFirstFrameMs,
    FrameTimeStatistics.Summary times,
    double processorMs,
    FramePolygonStatistics polygons,
    FramePolygonStatistics drawn,
    double peakMegabytes,
    GlInfo gl,
    ShadingMode shading,
    LatencyHistogram latency,
    double trackerSilence,
    Optional<HeadsetMetrics> headset,
    Optional<DisplayTiming> display) {
  /** A frame is slow if it took this many times the median. */
  private static final double SLOW = 1.5;

  /** Returns these measurements with how the window's frames were paced. */
  public RunMetrics pacedBy(Optional<DisplayTiming> timing) {
    return new RunMetrics(
        loadMs,
        firstFrameMs,
        processToFirstFrameMs,
        times,
        processorMs,
        polygons,
        drawn,
        peakMegabytes,
        gl,
        shading,
        latency,
        trackerSilence,
        headset,
        timing);
  }

  /**
   * Returns the measurements as the JSON object that the command line documents; the last line ends
   * with a line feed.
   */
  public String json() {
    ObjectNode node = JsonTree.object();
    node.put("frames", polygons.frames());
    node.put("fps", DecimalRounding.to(1, times.framesPerSecond()));
    node.put("load_ms", DecimalRounding.to(1, loadMs));
    node.put("first_frame_ms", DecimalRounding.to(1, firstFrameMs));
    node.put("process_to_first_frame_ms", DecimalRounding.to(1, processToFirstFrameMs));
    ObjectNode frame = node.putObject("frame_ms");
    frame
        .put("p50", DecimalRounding.to(2, times.p50()))
        .put("p95", DecimalRounding.to(2, times.p95()))
        .put("p99", DecimalRounding.to(2, times.p99()))
        .put("max", DecimalRounding.to(2, times.max()))
        .put("slow_share", DecimalRounding.to(4, times.shareAbove(SLOW * times.p50())));
    if (processorMs > 0) {
      frame.put("processor", DecimalRounding.to(2, processorMs));
    }
    polygons.put(node.putObject("polygons"));
    drawn.put(node.putObject("polygons_drawn"));
    if (latency.count() > 0) {
      node.putObject("latency_ms")
          .put("p50", DecimalRounding.to(2, latency.percentileMs(0.5)))
          .put("p99", DecimalRounding.to(2, latency.percentileMs(0.99)))
          .put("max", DecimalRounding.to(2, latency.maxMs()))
          .put("records", latency.count());
    }
    if (trackerSilence > 0) {
      node.put("tracker_silence_s", DecimalRounding.to(2, trackerSilence));
    }
    headset.ifPresent(worn -> worn.put(node.putObject("headset")));
    display.ifPresent(
        timing ->
            node.putObject("display")
                .put("refresh_hz", DecimalRounding.to(2, timing.hertz()))
                .put("vsync", timing.synchronised()));
    node.put("peak_rss_mb", DecimalRounding.to(1, peakMegabytes));
    node.putObject("gl")
        .put("vendor", gl.vendor())
        .put("renderer", gl.renderer())
        .put("version", gl.version())
        .put("shading", shading.on(gl).name().toLowerCase(Locale.ROOT));
    return JsonWriter.of(node);
  }
}
