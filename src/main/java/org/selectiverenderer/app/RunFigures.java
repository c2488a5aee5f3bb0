package org.selectiverenderer.app;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ObjectNode;
import org.selectiverenderer.runtime.render.FrameTimes;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.tracker.LatencyMeter;

/**
 * The figures of a run.
 *
 * @param loadMs from the beginning of reading until the scene is ready to be stepped
 * @param firstFrameMs from the beginning of reading until the first frame is completely drawn
 * @param processToFirstFrameMs from the start of the process until then
 * @param times of the frames after the first, from one to the next
 * @param polygons of the whole scene in its versions, seen or not, per frame
 * @param drawn triangles sent to the graphics card after culling, per frame and for all eyes
 * @param latency from the arrival of a tracker's record until the frame that shows it is submitted
 */
public record RunFigures(
    double loadMs,
    double firstFrameMs,
    double processToFirstFrameMs,
    FrameTimes.Summary times,
    PolygonCount polygons,
    PolygonCount drawn,
    double peakMegabytes,
    GlInfo gl,
    LatencyMeter latency) {

  /** The JSON object that the command line promises. */
  public String json() {
    ObjectMapper mapper = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);
    ObjectNode node = mapper.createObjectNode();
    node.put("frames", polygons.frames());
    node.put("fps", tenth(times.framesPerSecond()));
    node.put("load_ms", tenth(loadMs));
    node.put("first_frame_ms", tenth(firstFrameMs));
    node.put("process_to_first_frame_ms", tenth(processToFirstFrameMs));
    node.putObject("frame_ms")
        .put("p50", hundredth(times.p50()))
        .put("p95", hundredth(times.p95()))
        .put("p99", hundredth(times.p99()))
        .put("max", hundredth(times.max()));
    polygons.put(node.putObject("polygons"));
    drawn.put(node.putObject("polygons_drawn"));
    if (latency.count() > 0) {
      node.putObject("latency_ms")
          .put("p50", hundredth(latency.percentileMs(0.5)))
          .put("p99", hundredth(latency.percentileMs(0.99)))
          .put("records", latency.count());
    }
    node.put("peak_rss_mb", tenth(peakMegabytes));
    node.putObject("gl")
        .put("vendor", gl.vendor())
        .put("renderer", gl.renderer())
        .put("version", gl.version());
    return node.toPrettyString();
  }

  private static double tenth(double value) {
    return Math.round(value * 10) / 10.0;
  }

  private static double hundredth(double value) {
    return Math.round(value * 100) / 100.0;
  }
}
