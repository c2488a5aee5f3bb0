package org.selectiverenderer.apartment.kitchen;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/**
 * A stack of six plates, four white ones and two smaller blue ones, whose brims are fluted between
 * two beads: 200 steps of a profile with 54 bands each.
 */
final class Plates {
  private static final int SEGMENTS = 200;
  private static final int FLUTES = 48;

  /** Height from one plate of a stack to the next, metres. */
  private static final double STEP = 0.0115;

  private Plates() {}

  static ParametricModel model() {
    TriangleMesh large = plate();
    TriangleMesh small = large.scale(0.76, 1, 0.76).turnY(7);
    return ModelPlacement.centred(
        "plates",
        Part.of("dinnerPlates", Materials.CHINA, MeshPatterns.row(large, 4, 0, STEP, 0)),
        Part.of(
            "dessertPlates",
            Materials.BLUE_CHINA,
            MeshPatterns.row(small, 2, 0, STEP, 0).move(0, 4 * STEP, 0)));
  }

  /** Returns a plate 0.26 m wide: foot ring, brim with a relief, flat middle. */
  private static TriangleMesh plate() {
    ProfileCurve under =
        ProfileCurve.of(0, 0.003, 0.04, 0.003, 0.066, 0.003, 0.069, 0.0022, 0.07, 0.0004, 0.0708, 0)
            .line(0.073, 0)
            .line(0.0745, 0.0025)
            .spline(5, 0.09, 0.008, 0.11, 0.0145, 0.1275, 0.0185);
    ProfileCurve edge = ProfileCurve.from(0.1283, 0.0188).arc(0.1275, 0.0212, 135, 6);
    ProfileCurve brim =
        ProfileCurve.from(0.1262, 0.0234)
            .spline(1, 0.1248, 0.0244, 0.1234, 0.0234, 0.1222, 0.023)
            .spline(3, 0.117, 0.022, 0.111, 0.0208, 0.105, 0.0195)
            .spline(1, 0.1036, 0.0204, 0.1022, 0.0192);
    ProfileCurve middle =
        ProfileCurve.from(0.098, 0.0172)
            .spline(3, 0.086, 0.0114, 0.076, 0.0086, 0.066, 0.0078)
            .line(0, 0.0076);
    return Lathe.solid(under.then(edge).then(brim).then(middle), SEGMENTS).deform(Plates::waved);
  }

  /** Flutes the upper side of the brim; its edge stays round. */
  private static Vector3d waved(Vector3d p) {
    double radius = ModelPlacement.fromAxis(p.x, p.z);
    double share = Math.max(0, 1 - Math.abs(radius - 0.1128) / 0.0105);
    boolean above = p.y > 0.0182 + 0.19 * (radius - 0.1022);
    double wave = 1 - Math.abs(DegreeMath.sin(FLUTES / 2.0 * DegreeMath.atan2(-p.z, p.x)));
    return above ? p.add(0, -0.0005 * share * wave, 0) : p;
  }
}
