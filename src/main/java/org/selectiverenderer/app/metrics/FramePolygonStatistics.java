package org.selectiverenderer.app.metrics;

import com.fasterxml.jackson.databind.node.ObjectNode;
import org.selectiverenderer.base.decimal.DecimalRounding;

/**
 * Minimum, mean and maximum of the polygons per frame over a run.
 *
 * @param frames number of frames counted
 */
record FramePolygonStatistics(long frames, long min, double mean, long max) {
  /** The statistics before the first frame. */
  public static final FramePolygonStatistics NONE = new FramePolygonStatistics(0, 0, 0, 0);

  /** Returns the statistics with one more frame. */
  FramePolygonStatistics with(long polygons) {
    return new FramePolygonStatistics(
        frames + 1,
        frames == 0 ? polygons : Math.min(min, polygons),
        mean + (polygons - mean) / (frames + 1),
        Math.max(max, polygons));
  }

  void put(ObjectNode node) {
    node.put("min", min).put("mean", DecimalRounding.to(1, mean)).put("max", max);
  }
}
