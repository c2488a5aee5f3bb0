package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/** A wide bowl of blue china, 0.32 m across. */
final class Bowl {

  private Bowl() {}

  static ParametricModel model() {
    ProfileCurve wall = ProfileCurve.of(0.055, 0, 0.125, 0.045, 0.16, 0.1);
    return ParametricModel.of(
        "bowl",
        Part.of("china", Materials.BLUE_CHINA, Lathe.solid(wall.line(0.152, 0.1).line(0, 0.02), 12))
            .crease(60));
  }
}
