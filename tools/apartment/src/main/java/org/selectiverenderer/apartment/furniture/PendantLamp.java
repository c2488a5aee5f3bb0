package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;

/** A drum of cream cloth on a cord, 0.6 m from the ceiling to its lower edge. */
final class PendantLamp {
  private static final double RADIUS = 0.25;
  private static final double DRUM = 0.2;
  private static final double LENGTH = 0.6;

  private PendantLamp() {}

  static ParametricModel model() {
    ProfileCurve drum = ProfileCurve.of(0, 0, RADIUS, 0, RADIUS, DRUM);
    return ModelPlacement.centred(
        "pendantLamp",
        Part.of("shade", Materials.CREAM_CLOTH, Lathe.surface(drum, 16)),
        Part.of(
            "cord",
            Materials.STEEL,
            RoundSolidBuilder.cylinder(0.004, LENGTH - 0.01, 4),
            RoundSolidBuilder.cone(0.055, 0.05, 0.025, 6).move(0, LENGTH - 0.025, 0)));
  }
}
