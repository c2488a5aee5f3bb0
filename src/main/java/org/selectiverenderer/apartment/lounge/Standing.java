package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.modelling.Bounds;
import org.selectiverenderer.modelling.Model;

/** Puts models where the recipes' frame has them. */
final class Standing {

  private Standing() {}

  /** The model moved to stand on y = 0, its box centred on x and z. */
  static Model centred(Model model) {
    Bounds b = model.bounds();
    return model.map(
        mesh -> mesh.move(-(b.minX() + b.maxX()) / 2, -b.minY(), -(b.minZ() + b.maxZ()) / 2));
  }
}
