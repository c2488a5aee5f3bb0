package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/** A round stool of cloth, 0.52 m across. */
final class Pouf {

  private Pouf() {}

  static ParametricModel model() {
    ProfileCurve side = ProfileCurve.of(0.22, 0, 0.26, 0.05, 0.26, 0.33, 0.2, 0.39, 0, 0.4);
    return ParametricModel.of(
        "pouf", Part.of("cloth", Materials.RUST_CLOTH, Lathe.solid(side, 16)).crease(60));
  }
}
