package org.selectiverenderer.app.metrics;

import com.fasterxml.jackson.databind.node.ObjectNode;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.tracker.LatencyHistogram;

/**
 * The performance measurements of a headset in a run.
 *
 * @param runtime name and version of the OpenXR runtime that drove the headset
 * @param rate frames per second that the headset asked for
 * @param frames number of frames due so far
 * @param missed number of frames that were not ready in time
 * @param lead how long before the display of each frame its pose was predicted
 */
public record HeadsetMetrics(
    String runtime, double rate, long frames, long missed, LatencyHistogram lead) {
  void put(ObjectNode node) {
    node.put("runtime", runtime)
        .put("rate_hz", DecimalRounding.to(1, rate))
        .put("frames", frames)
        .put("missed", missed);
    if (lead.count() > 0) {
      node.putObject("lead_ms")
          .put("p50", DecimalRounding.to(2, lead.percentileMs(0.5)))
          .put("p99", DecimalRounding.to(2, lead.percentileMs(0.99)))
          .put("max", DecimalRounding.to(2, lead.maxMs()));
    }
  }
}
