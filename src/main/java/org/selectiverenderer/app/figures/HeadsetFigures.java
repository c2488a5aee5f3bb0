package org.selectiverenderer.app.figures;

import com.fasterxml.jackson.databind.node.ObjectNode;
import org.selectiverenderer.base.decimal.Rounded;
import org.selectiverenderer.tracker.LatencyMeter;

/**
 * The figures of a headset in a run.
 *
 * @param runtime that drove it: name and version
 * @param rate frames per second that it wanted
 * @param frames due so far
 * @param missed frames that were not ready in time
 * @param lead how far ahead of the picture the pose of each frame was asked for
 */
public record HeadsetFigures(
    String runtime, double rate, long frames, long missed, LatencyMeter lead) {
  void put(ObjectNode node) {
    node.put("runtime", runtime)
        .put("rate_hz", Rounded.to(1, rate))
        .put("frames", frames)
        .put("missed", missed);
    if (lead.count() > 0) {
      node.putObject("lead_ms")
          .put("p50", Rounded.to(2, lead.percentileMs(0.5)))
          .put("p99", Rounded.to(2, lead.percentileMs(0.99)))
          .put("max", Rounded.to(2, lead.maxMs()));
    }
  }
}
