package org.selectiverenderer.enricher.preview;

import java.util.Collection;
import java.util.Optional;
import org.selectiverenderer.runtime.instance.ShapeInstance;

/** The box around boxes; each is min x, y, z, max x, y, z. */
final class Bounds {
  private final double[] box = {
    Double.POSITIVE_INFINITY,
    Double.POSITIVE_INFINITY,
    Double.POSITIVE_INFINITY,
    Double.NEGATIVE_INFINITY,
    Double.NEGATIVE_INFINITY,
    Double.NEGATIVE_INFINITY
  };

  void add(double[] other) {
    if (other[0] <= other[3]) {
      for (int axis = 0; axis < 3; axis++) {
        box[axis] = Math.min(box[axis], other[axis]);
        box[axis + 3] = Math.max(box[axis + 3], other[axis + 3]);
      }
    }
  }

  /** Empty when nothing was added. */
  Optional<double[]> box() {
    return box[0] <= box[3] ? Optional.of(box.clone()) : Optional.empty();
  }

  /** Around the shapes that are shown. */
  static Optional<double[]> of(Collection<ShapeInstance> shapes) {
    Bounds all = new Bounds();
    for (ShapeInstance shape : shapes) {
      if (shape.shown()) {
        all.add(shape.bounds());
      }
    }
    return all.box();
  }
}
