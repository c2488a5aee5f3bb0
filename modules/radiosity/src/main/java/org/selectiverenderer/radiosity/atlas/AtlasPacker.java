package org.selectiverenderer.radiosity.atlas;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Packs the charts of each file's bodies on pages, each body on one page, and keeps the pages as
 * small as it can.
 */
final class AtlasPacker {
  /** Sides of pages are multiples of this. */
  private static final int MULTIPLE = 4;

  /** Widths tried for a page, as shares of the side of a square. */
  private static final double[] WIDTHS = {1.0, 1.04, 1.08, 1.13, 1.2, 1.3, 1.5};

  /** Charts on a page beyond which only few widths are tried. */
  private static final int MANY = 20_000;

  /** Share of the largest page's area up to which bodies are tried on one page at first. */
  private static final double HOPE = 0.92;

  /**
   * Boxes with sides of at most half of a page's and this share of its area fit on it in any case:
   * packed in shelves by height they are no higher than the highest box and twice their area.
   */
  private static final double SURE = 0.2;

  private final ChartRectangles boxes;
  private final int largest;

  /** A page and the bodies on it. */
  record Page(int width, int height, List<Integer> bodies) {
    long texels() {
      return (long) width * height;
    }
  }

  AtlasPacker(ChartRectangles boxes, int largest) {
    this.boxes = boxes;
    this.largest = largest;
  }

  /**
   * Returns whether a body alone fits on a page.
   *
   * @param texels number of texels that it takes
   */
  boolean fits(int body, long texels) {
    int longest = boxes.longest(body) + ChartRectangles.GUTTER;
    double area = (double) largest * largest;
    return longest < largest
        && texels < area
        && (longest <= largest / 2 && texels < SURE * area || page(List.of(body), texels) != null);
  }

  /**
   * Returns the pages of bodies; null if one of them does not fit on a page.
   *
   * @param texels number of texels of each body
   */
  @Nullable List<Page> plan(List<Integer> bodies, long[] texels) {
    List<Page> pages = new ArrayList<>();
    int from = 0;
    while (from < bodies.size()) {
      long sum = 0;
      int to = from;
      while (to < bodies.size()
          && (to == from || sum + texels[bodies.get(to)] <= HOPE * largest * largest)) {
        sum += texels[bodies.get(to++)];
      }
      Page page = page(bodies.subList(from, to), sum);
      while (page == null && to > from + 1) {
        to = Math.max(from + 1, to - 1 - (to - from) / 10);
        sum = 0;
        for (int i = from; i < to; i++) {
          sum += texels[bodies.get(i)];
        }
        page = page(bodies.subList(from, to), sum);
      }
      if (page == null) {
        return null;
      }
      pages.add(page);
      from = to;
    }
    return pages;
  }

  /** Returns the smallest page found that holds these bodies; null if the largest page does not. */
  private @Nullable Page page(List<Integer> bodies, long texels) {
    int count = 0;
    int widest = 0;
    for (int body : bodies) {
      count += boxes.end(body) - boxes.first(body);
      widest = Math.max(widest, boxes.longest(body));
    }
    long[] order = new long[count];
    int n = 0;
    for (int body : bodies) {
      for (int i = boxes.first(body); i < boxes.end(body); i++) {
        // Sort key: high boxes before low ones, wide before narrow.
        order[n++] =
            (long) (0x7fff - boxes.height[i]) << 48 | (long) (0xffff - boxes.width[i]) << 32 | i;
      }
    }
    Arrays.sort(order);
    int bestWidth = 0;
    int bestHeight = 0;
    long best = Long.MAX_VALUE;
    int last = 0;
    for (int k = 0; k < WIDTHS.length; k += count > MANY ? 3 : 1) {
      double side = WIDTHS[k] * Math.sqrt(texels);
      int width =
          Math.min(largest, multiple(Math.max(side, widest + ChartRectangles.GUTTER + 1.0)));
      if (width == last) {
        continue;
      }
      last = width;
      int height = multiple(pack(order, width));
      if (height <= largest && (long) width * height < best) {
        best = (long) width * height;
        bestWidth = width;
        bestHeight = height;
      }
    }
    if (bestWidth == 0 && last < largest) {
      bestWidth = largest;
      bestHeight = multiple(pack(order, largest));
    }
    if (bestWidth == 0 || bestHeight > largest) {
      return null;
    }
    if (bestWidth != last) {
      pack(order, bestWidth);
    }
    return new Page(bestWidth, bestHeight, List.copyOf(bodies));
  }

  /** Packs all boxes into a page of a width; returns the height of the page. */
  private int pack(long[] order, int width) {
    // A gutter of one texel at the left and the bottom, and of two beyond every box, since pages
    // repeat.
    SkylinePacker skyline = new SkylinePacker(width - 1);
    for (long entry : order) {
      int box = (int) entry;
      skyline.place(
          Math.min(width - 1, boxes.width[box] + ChartRectangles.GUTTER),
          boxes.height[box] + ChartRectangles.GUTTER);
      boxes.x[box] = skyline.x() + 1;
      boxes.y[box] = skyline.y() + 1;
    }
    return skyline.height() + 1;
  }

  private static int multiple(double side) {
    return (int) Math.ceil(side / MULTIPLE) * MULTIPLE;
  }
}
