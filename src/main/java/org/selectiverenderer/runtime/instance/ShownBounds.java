package org.selectiverenderer.runtime.instance;

import java.util.Collection;
import java.util.Optional;
import org.selectiverenderer.geometry.Bounds;

/** The box around shapes, in the world. */
public final class ShownBounds {
  private ShownBounds() {}

  /** Around the shapes that are shown; empty when they fill no space. */
  public static Optional<Bounds> of(Collection<ShapeInstance> shapes) {
    return shapes.stream()
        .filter(ShapeInstance::shown)
        .map(shape -> Bounds.of(shape.bounds()))
        .reduce(Bounds::union)
        .filter(all -> !all.isEmpty());
  }
}
