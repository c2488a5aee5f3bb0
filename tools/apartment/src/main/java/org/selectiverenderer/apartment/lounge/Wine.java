package org.selectiverenderer.apartment.lounge;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/** A bottle of red wine, 0.3 m high: green glass, a paper label with two gold lines, a capsule. */
final class Wine {
  private static final double RADIUS = 0.0375;

  private Wine() {}

  static ParametricModel model() {
    TriangleMesh bottle = Lathe.solid(profile(), 72);
    ModelMaterial glass = ModelMaterial.glossy(ModelColour.of(0.03, 0.1, 0.05));
    ModelMaterial gold = ModelMaterial.metal(ModelColour.of(0.85, 0.66, 0.3));
    ModelMaterial capsule = ModelMaterial.satin(ModelColour.of(0.36, 0.04, 0.07));
    ModelMaterial ink = ModelMaterial.matt(ModelColour.of(0.36, 0.04, 0.07));
    return ParametricModel.of(
        "wine",
        Part.of("glass", glass, SurfacePartition.where(bottle, p -> !isCapsule(p) && !isLabel(p))),
        Part.of("capsule", capsule, SurfacePartition.where(bottle, Wine::isCapsule)),
        Part.of(
            "label",
            Materials.CREAM_PAPER,
            SurfacePartition.where(bottle, p -> isLabel(p) && !isPrint(p))),
        Part.of("gold", gold, SurfacePartition.where(bottle, p -> isLabel(p) && isGold(p))),
        Part.of("emblem", ink, SurfacePartition.where(bottle, p -> isLabel(p) && isEmblem(p))));
  }

  private static ProfileCurve profile() {
    return ProfileCurve.from(0, 0.018)
        .spline(6, 0.018, 0.012, 0.029, 0)
        .spline(4, 0.034, 0.0008, RADIUS, 0.006)
        .spline(4, RADIUS, 0.05)
        .spline(24, RADIUS, 0.146)
        .spline(4, RADIUS, 0.18)
        .bezier(RADIUS, 0.205, 0.0155, 0.205, 0.0145, 0.232, 24)
        .spline(8, 0.0142, 0.27)
        .spline(2, 0.0142, 0.281)
        .arc(0.0142, 0.284, 180, 8)
        .spline(2, 0.0142, 0.2885, 0.0142, 0.297)
        .arc(0.0122, 0.297, 90, 4)
        .line(0.009, 0.299)
        .line(0, 0.2985);
  }

  private static boolean isCapsule(Vector3d p) {
    return p.y > 0.238;
  }

  private static boolean isLabel(Vector3d p) {
    return p.y > 0.05 && p.y < 0.146 && Math.abs(angle(p)) < 75;
  }

  private static boolean isPrint(Vector3d p) {
    return isGold(p) || isEmblem(p);
  }

  private static boolean isGold(Vector3d p) {
    return p.y > 0.058 && p.y < 0.062 || p.y > 0.134 && p.y < 0.138;
  }

  /** Returns whether a point lies in the dark field in the label's middle. */
  private static boolean isEmblem(Vector3d p) {
    return p.y > 0.094 && p.y < 0.122 && Math.abs(angle(p)) < 30
        || p.y > 0.078 && p.y < 0.082 && Math.abs(angle(p)) < 50;
  }

  /** Returns the angle of a point about the bottle's axis from the front, degrees. */
  private static double angle(Vector3d p) {
    return DegreeMath.atan2(p.x, p.z);
  }
}
