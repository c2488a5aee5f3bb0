package org.selectiverenderer.apartment.kitchen;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;

/**
 * A roll of paper towels on a wooden stand, 0.31 m high, with the end of the paper hanging loose.
 */
final class KitchenRoll {
  private static final double RADIUS = 0.058;

  private KitchenRoll() {}

  static ParametricModel model() {
    ProfileCurve stand =
        ProfileCurve.of(
                0, 0, 0.072, 0, 0.075, 0.004, 0.075, 0.012, 0.07, 0.017, 0.009, 0.017, 0.009, 0.285)
            .line(0.017, 0.294)
            .line(0.014, 0.307)
            .line(0, 0.312);
    TriangleMesh roll = RoundSolidBuilder.pipe(RADIUS, 0.02, 0.24, 22).move(0, 0.018, 0);
    return ModelPlacement.centred(
        "kitchenRoll",
        Part.of("stand", Materials.LIGHT_OAK, Lathe.solid(stand, 14)),
        Part.of("paper", ModelMaterial.matt(ModelColour.hex(0xF0EEE8)), roll, loose()));
  }

  /**
   * Returns the loose end of the paper, which leaves the roll in front and swings out to the right.
   */
  private static TriangleMesh loose() {
    TriangleMesh sheet =
        ParametricSurface.of(
            6,
            1,
            (u, v) ->
                new Vector3d(
                    0.075 * u,
                    0.018 + 0.24 * v,
                    RADIUS + 0.008 * DegreeMath.sin(200 * u) + 0.0005));
    return ParametricSurface.thicken(sheet, 0, 0, 0.0008);
  }
}
