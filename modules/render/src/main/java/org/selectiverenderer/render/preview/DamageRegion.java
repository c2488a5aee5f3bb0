package org.selectiverenderer.render.preview;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.render.draw.PixelRectangle;

/**
 * A few rectangles that hold all pixels that are to be drawn again. Those that overlap, or are so
 * near one another that drawing what lies between costs less than another pass, are one.
 */
final class DamageRegion {
  /** Most rectangles; more are united. */
  private static final int MOST = 4;

  /**
   * Pixels that are drawn in vain rather than in a pass of their own: on a software renderer a pass
   * of a few pixels takes as long.
   */
  private static final long PASS = 10_000;

  private final List<PixelRectangle> found = new ArrayList<>();

  /** Adds the pixels of a rectangle. */
  void add(PixelRectangle more) {
    PixelRectangle added = more;
    for (int i = cheapest(added); i >= 0; i = cheapest(added)) {
      added = added.union(found.remove(i));
    }
    found.add(added);
  }

  /** Returns the rectangle that is best united with another; -1 where none has to be. */
  private int cheapest(PixelRectangle with) {
    int best = -1;
    long least = found.size() < MOST ? PASS : Long.MAX_VALUE;
    for (int i = 0; i < found.size(); i++) {
      PixelRectangle each = found.get(i);
      long lost = each.union(with).area() - each.area() - with.area();
      if (lost < least) {
        least = lost;
        best = i;
      }
    }
    return best;
  }

  List<PixelRectangle> rectangles() {
    return List.copyOf(found);
  }
}
