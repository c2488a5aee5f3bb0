package org.selectiverenderer.runtime.instance;

import java.util.Collection;
import java.util.Optional;
import org.selectiverenderer.geometry.Bounds;

/** Computes the world-space bounding box of the visible shapes. */
public final class ShownBounds {
  private ShownBounds() {}

  /**
   * Returns the bounding box of those of the given shapes that are shown; empty if they have no
   * extent.
   */
  public static Optional<Bounds> of(Collection<ShapeInstance> shapes) {
    return shapes.stream()
        .filter(ShapeInstance::shown)
        .map(shape -> Bounds.of(shape.bounds()))
        .reduce(Bounds::union)
        .filter(all -> !all.isEmpty());
  }
}
