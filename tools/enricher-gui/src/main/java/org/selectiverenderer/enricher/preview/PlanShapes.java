package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * The shapes that a plan shows: not sky domes, nor what the author has hidden; and the part of the
 * ground that it covers, for which endless grounds do not count.
 *
 * @param drawn the shapes to be drawn
 * @param extent the bounds of those that count; empty if there are none
 */
record PlanShapes(List<ShapeInstance> drawn, Optional<BoundingBox> extent) {
  /** A background is so many times wider than all that is not. */
  private static final double WIDER = 3;

  /** Least width of a background, in metres, so that no room is taken for one. */
  private static final double LEAST = 60;

  /** Least height of a sky dome and most height of a ground, as shares of their width. */
  private static final double DOME = 0.35;

  private static final double FLAT = 0.05;

  private static final int MOST_BACKGROUNDS = 32;

  private record Sized(ShapeInstance shape, BoundingBox box) {
    double width() {
      return Math.max(box.width(), box.depth());
    }

    boolean background() {
      double height = box.height() / width();
      return width() >= LEAST && (height >= DOME || height <= FLAT);
    }
  }

  /**
   * Chooses the shapes of a plan.
   *
   * @param hidden shapes that are left out
   */
  static PlanShapes of(Collection<ShapeInstance> shapes, Set<ShapeInstance> hidden) {
    List<Sized> all = new ArrayList<>();
    for (ShapeInstance shape : shapes) {
      double[] bounds = shape.bounds();
      if (shape.shown() && !hidden.contains(shape) && bounds[0] <= bounds[3]) {
        all.add(new Sized(shape, BoundingBox.of(bounds)));
      }
    }
    all.sort(Comparator.comparingDouble(Sized::width).reversed());
    int backgrounds = backgrounds(all);
    List<ShapeInstance> drawn = new ArrayList<>();
    for (int i = 0; i < all.size(); i++) {
      boolean dome = i < backgrounds && all.get(i).box().height() >= DOME * all.get(i).width();
      if (!dome) {
        drawn.add(all.get(i).shape());
      }
    }
    return new PlanShapes(
        drawn,
        all.subList(backgrounds, all.size()).stream()
            .map(Sized::box)
            .reduce(BoundingBox::union)
            .filter(box -> box.width() > 0 && box.depth() > 0));
  }

  /** Returns how many of the widest shapes are backgrounds. */
  private static int backgrounds(List<Sized> widestFirst) {
    int most = Math.min(MOST_BACKGROUNDS, widestFirst.size() - 1);
    int found = 0;
    for (int i = 1; i <= most && widestFirst.get(i - 1).background(); i++) {
      BoundingBox rest = BoundingBox.EMPTY;
      for (Sized each : widestFirst.subList(i, widestFirst.size())) {
        rest = rest.union(each.box());
      }
      double width = Math.max(rest.width(), rest.depth());
      if (width > 0 && widestFirst.get(i - 1).width() > WIDER * width) {
        found = i;
      }
    }
    return found;
  }
}
