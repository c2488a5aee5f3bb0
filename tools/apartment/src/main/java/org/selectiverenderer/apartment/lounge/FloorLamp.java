package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;

/** A lamp that stands on the floor, 1.6 m high, with a cloth shade. */
final class FloorLamp {

  private FloorLamp() {}

  static ParametricModel model() {
    ProfileCurve stand =
        ProfileCurve.of(0.14, 0, 0.14, 0.012, 0.05, 0.026, 0.014, 0.05, 0.011, 1.22, 0.02, 1.235)
            .line(0.02, 1.3);
    ProfileCurve shade = ProfileCurve.of(0.24, 1.24, 0.15, 1.6, 0.146, 1.6, 0.236, 1.24);
    ModelMaterial cloth =
        ModelMaterial.matt(ModelColour.of(0.92, 0.84, 0.66))
            .glowing(ModelColour.of(0.32, 0.26, 0.15));
    ModelMaterial bulb =
        ModelMaterial.matt(ModelColour.of(1, 0.96, 0.85)).glowing(ModelColour.of(0.9, 0.8, 0.6));
    return ParametricModel.of(
        "floorLamp",
        Part.of("stand", Materials.PALE_BRASS, Lathe.solid(stand, 10)),
        Part.of("bulb", bulb, RoundSolidBuilder.sphere(0.04, 3, 6).move(0, 1.34, 0)),
        Part.of("shade", cloth, Lathe.surface(shade, 16)));
  }
}
