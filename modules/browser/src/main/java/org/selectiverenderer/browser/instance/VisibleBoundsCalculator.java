package org.selectiverenderer.browser.instance;

import java.util.Collection;
import java.util.Optional;
import org.selectiverenderer.geometry.BoundingBox;

/** Computes the world-space bounding box of the visible shapes. */
public final class VisibleBoundsCalculator {
  private VisibleBoundsCalculator() {}

  /**
   * Returns the bounding box of those of the given shapes that are shown; empty if they have no
   * extent.
   */
  public static Optional<BoundingBox> of(Collection<ShapeInstance> shapes) {
    return shapes.stream()
        .filter(ShapeInstance::shown)
        .map(shape -> BoundingBox.of(shape.bounds()))
        .reduce(BoundingBox::union)
        .filter(all -> !all.isEmpty());
  }
}
