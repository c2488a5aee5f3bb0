package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.atlas.AtlasPage;

/**
 * Hole filling of a page: hidden texels take the mean light of the texels around them in their
 * chart, so that filtering carries no darkness to visible places; then gutters take the light of
 * the nearest chart.
 */
final class TexelHoleFilling {
  private final AtlasPage map;
  private final float[] light;
  private int[] border;
  private int count;

  private TexelHoleFilling(AtlasPage map, float[] light) {
    this.map = map;
    this.light = light;
    border = new int[256];
  }

  /**
   * Fills the texels of charts that are not gathered. A chart without any gathered texel keeps its
   * values.
   *
   * @param light r, g, b per texel
   */
  static void inCharts(AtlasPage map, float[] light, TexelIndex texels, int page) {
    boolean[] has = new boolean[map.texels()];
    for (int i = 0; i < has.length; i++) {
      has[i] = texels.wanted(texels.first(page) + i);
    }
    new TexelHoleFilling(map, light).grow(has, true);
  }

  /** Fills the gutters. */
  static void gutters(AtlasPage map, float[] light) {
    boolean[] has = new boolean[map.texels()];
    for (int i = 0; i < has.length; i++) {
      has[i] = map.chart()[i] != AtlasPage.NONE;
    }
    new TexelHoleFilling(map, light).grow(has, false);
  }

  /** Dilates the texels that have light by one texel per round until no texel is left to fill. */
  private void grow(boolean[] has, boolean inChart) {
    count = 0;
    for (int i = 0; i < has.length; i++) {
      if (!has[i] && neighbours(i, has, inChart, null) > 0) {
        push(i);
      }
    }
    double[] sum = new double[3];
    boolean[] queued = new boolean[has.length];
    while (count > 0) {
      int[] now = Arrays.copyOf(border, count);
      for (int i : now) {
        Arrays.fill(sum, 0);
        int from = neighbours(i, has, inChart, sum);
        for (int c = 0; c < 3; c++) {
          light[3 * i + c] = (float) (sum[c] / from);
        }
      }
      for (int i : now) {
        has[i] = true;
      }
      count = 0;
      for (int i : now) {
        around(i, has, inChart, queued);
      }
    }
  }

  private void around(int i, boolean[] has, boolean inChart, boolean[] queued) {
    int x = i % map.width();
    int y = i / map.width();
    for (int ny = Math.max(0, y - 1); ny <= Math.min(map.height() - 1, y + 1); ny++) {
      for (int nx = Math.max(0, x - 1); nx <= Math.min(map.width() - 1, x + 1); nx++) {
        int there = ny * map.width() + nx;
        if (!has[there] && !queued[there] && joined(i, there, inChart)) {
          queued[there] = true;
          push(there);
        }
      }
    }
  }

  private boolean joined(int one, int other, boolean inChart) {
    return inChart
        ? map.chart()[other] != AtlasPage.NONE && map.chart()[one] == map.chart()[other]
        : map.chart()[other] == AtlasPage.NONE;
  }

  private int neighbours(int i, boolean[] has, boolean inChart, double @Nullable [] sum) {
    int x = i % map.width();
    int y = i / map.width();
    int found = 0;
    for (int ny = Math.max(0, y - 1); ny <= Math.min(map.height() - 1, y + 1); ny++) {
      for (int nx = Math.max(0, x - 1); nx <= Math.min(map.width() - 1, x + 1); nx++) {
        int there = ny * map.width() + nx;
        if (has[there] && joined(there, i, inChart)) {
          found++;
          for (int c = 0; c < 3 && sum != null; c++) {
            sum[c] += light[3 * there + c];
          }
        }
      }
    }
    return found;
  }

  private void push(int texel) {
    if (count == border.length) {
      border = Arrays.copyOf(border, 2 * count);
    }
    border[count++] = texel;
  }
}
