package org.selectiverenderer.apartment.lounge;

import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/**
 * A glass of red wine. The wall is a single two-sided surface, which has the wine's material where
 * the wine is.
 */
final class Glass {
  private static final int SEGMENTS = 16;
  private static final double RADIUS = 0.0388;
  private static final double LEVEL = 0.14;

  private Glass() {}

  static ParametricModel model() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0.002, 0.035, 0)
            .spline(3, 0.012, 0.007, 0.0055, 0.02)
            .line(0.0055, 0.088)
            .spline(3, 0.021, 0.0985, 0.034, 0.118, RADIUS, LEVEL)
            .spline(2, 0.038, 0.17, 0.0325, 0.2);
    TriangleMesh wall = Lathe.surface(profile, SEGMENTS);
    TriangleMesh level = Lathe.surface(ProfileCurve.of(RADIUS, LEVEL, 0, LEVEL), SEGMENTS);
    ModelMaterial clear = ModelMaterial.glossy(ModelColour.of(0.75, 0.8, 0.82)).transparent(0.68);
    ModelMaterial red = ModelMaterial.glossy(ModelColour.of(0.3, 0.02, 0.05));
    return ParametricModel.of(
        "glass",
        Part.of("wine", red, SurfacePartition.where(wall, Glass::isWine), level).crease(60),
        Part.of("glass", clear, SurfacePartition.where(wall, p -> !isWine(p))).crease(60));
  }

  private static boolean isWine(Vector3d p) {
    return p.y > 0.088 && p.y < LEVEL;
  }
}
