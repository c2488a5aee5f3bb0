package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.radiosity.atlas.TexelMap;

/**
 * Regular grids of texels, one for each chart and beginning at the lower left corner of the chart,
 * so that every chart has grid texels.
 */
final class ChartGrid {
  private final TexelMap map;
  private final int lowest;
  private final int[] left;
  private final int[] bottom;

  ChartGrid(TexelMap map) {
    this.map = map;
    int low = Integer.MAX_VALUE;
    int high = -1;
    for (int chart : map.chart()) {
      if (chart != TexelMap.NONE) {
        low = Math.min(low, chart);
        high = Math.max(high, chart);
      }
    }
    lowest = high < 0 ? 0 : low;
    left = new int[high - lowest + 1];
    bottom = new int[left.length];
    Arrays.fill(left, Integer.MAX_VALUE);
    Arrays.fill(bottom, Integer.MAX_VALUE);
    for (int i = 0; i < map.texels(); i++) {
      if (map.chart()[i] != TexelMap.NONE) {
        int chart = map.chart()[i] - lowest;
        left[chart] = Math.min(left[chart], i % map.width());
        bottom[chart] = Math.min(bottom[chart], i / map.width());
      }
    }
  }

  /** Returns whether a texel of a chart is on the grid of a stride. */
  boolean on(int texel, int stride) {
    int chart = map.chart()[texel] - lowest;
    return (texel % map.width() - left[chart]) % stride == 0
        && (texel / map.width() - bottom[chart]) % stride == 0;
  }
}
