package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/**
 * A round ashtray of amber glass, 0.14 m wide, with four rests in its rim: twelve steps of a wall
 * outside, a rim and a wall inside, and two bottoms, 12 * (3 * 2 + 2) = 96 triangles.
 */
final class AshTray {

  private AshTray() {}

  static ParametricModel model() {
    ProfileCurve profile = ProfileCurve.of(0.058, 0, 0.07, 0.036, 0.054, 0.038, 0.044, 0.01);
    TriangleMesh dish = Lathe.solid(profile, 12).deform(p -> p.sub(0, depth(p.x, p.y, p.z), 0));
    ModelMaterial glass = ModelMaterial.glossy(ModelColour.of(0.5, 0.27, 0.08));
    ModelMaterial ash = ModelMaterial.matt(ModelColour.of(0.42, 0.4, 0.38));
    return ParametricModel.of(
        "ashTray",
        Part.of("dish", glass, SurfacePartition.where(dish, p -> !isBottom(p.x, p.y, p.z))),
        Part.of("ash", ash, SurfacePartition.where(dish, p -> isBottom(p.x, p.y, p.z))));
  }

  /** Returns the depth of the rim, which has rests for cigarettes where it crosses the axes. */
  private static double depth(double x, double y, double z) {
    return y > 0.03 && Math.abs(x * z) < 1e-9 ? 0.008 : 0;
  }

  private static boolean isBottom(double x, double y, double z) {
    return y > 0.009 && x * x + z * z < 0.03 * 0.03;
  }
}
