package org.selectiverenderer.enricher.preview;

import java.util.Collection;
import java.util.Optional;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.runtime.instance.ShapeInstance;

/** The box around shapes. */
final class ShownBounds {
  private ShownBounds() {}

  /** Around the shapes that are shown; empty when they fill no space. */
  static Optional<Bounds> of(Collection<ShapeInstance> shapes) {
    return shapes.stream()
        .filter(ShapeInstance::shown)
        .map(shape -> Bounds.of(shape.bounds()))
        .reduce(Bounds::union)
        .filter(all -> !all.isEmpty());
  }
}
