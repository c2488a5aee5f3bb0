package org.selectiverenderer.apartment.lounge;

import org.joml.Vector3d;
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
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A blue and white vase with three tulips, 0.47 m high. The leaves have borders. */
final class Vase {

  private Vase() {}

  static ParametricModel model() {
    TriangleMesh vase = Lathe.solid(profile(), 20);
    ModelMaterial white = ModelMaterial.satin(ModelColour.of(0.92, 0.91, 0.87));
    ModelMaterial blue = ModelMaterial.satin(ModelColour.of(0.13, 0.25, 0.45));
    ModelMaterial green = ModelMaterial.satin(ModelColour.of(0.25, 0.42, 0.16));
    ModelMaterial petals = ModelMaterial.satin(ModelColour.of(0.78, 0.2, 0.16));
    Spine[] stems = {stem(-0.09, 0.02, 0.385), stem(0.075, 0.045, 0.37), stem(0.015, -0.04, 0.41)};
    return ModelPlacement.centred(
        ParametricModel.of(
            "vase",
            Part.of("body", white, SurfacePartition.where(vase, p -> !isBand(p))).crease(60),
            Part.of("band", blue, SurfacePartition.where(vase, Vase::isBand)).crease(60),
            Part.of("stems", green, tube(stems[0]), tube(stems[1]), tube(stems[2])),
            Part.of("leaves", green, leaf(40), leaf(165), leaf(280)).crease(60),
            Part.of("tulips", petals, tulip(stems[0]), tulip(stems[1]), tulip(stems[2]))
                .crease(75)));
  }

  /** Returns the profile: up the belly to a neck with a lip, and down inside. */
  private static ProfileCurve profile() {
    return ProfileCurve.from(0.04, 0)
        .line(0.042, 0.006)
        .spline(3, 0.068, 0.06, 0.066, 0.13)
        .line(0.058, 0.155)
        .line(0.036, 0.195)
        .line(0.034, 0.215)
        .line(0.046, 0.24)
        .line(0.041, 0.24)
        .line(0.03, 0.21)
        .line(0.05, 0.14);
  }

  private static boolean isBand(Vector3d p) {
    return p.y > 0.131 && p.y < 0.155 && p.x * p.x + p.z * p.z > 0.054 * 0.054;
  }

  private static Spine stem(double x, double z, double height) {
    return Spine.smooth(
        2, -0.2 * x, 0.1, -0.2 * z, 0.3 * x, 0.24, 0.3 * z, 0.7 * x, 0.32, 0.7 * z, x, height, z);
  }

  private static TriangleMesh tube(Spine stem) {
    return Sweep.tube(stem, 0.0032, 5);
  }

  /** Returns a cup of petals in the direction of the stem's end. */
  private static TriangleMesh tulip(Spine stem) {
    ProfileCurve cup =
        ProfileCurve.of(0, 0, 0.018, 0.008, 0.024, 0.026, 0.0205, 0.045, 0.012, 0.02);
    TriangleMesh flower = Lathe.solid(cup, 12).deform(Vase::pointed);
    Vector3d end = stem.points().get(stem.points().size() - 1);
    double lean = 130 * Math.sqrt(end.x * end.x + end.z * end.z);
    return flower
        .turnX(2 * lean)
        .turnY(DegreeMath.atan2(end.x, end.z))
        .move(end.x, end.y - 0.003, end.z);
  }

  /** Raises every other point of the rim, which gives six tips. */
  private static Vector3d pointed(Vector3d p) {
    double turn = DegreeMath.atan2(p.z, p.x) / 60;
    boolean tip = Math.abs(turn - Math.rint(turn)) < 0.1;
    return p.y > 0.03 && tip ? p.add(0, 0.014, 0) : p;
  }

  private static TriangleMesh leaf(double degrees) {
    return ParametricSurface.of(
            2,
            6,
            (u, v) -> {
              double width = 0.034 * (1 - v) * (0.35 + 1.6 * v);
              double out = 0.012 + 0.085 * v * v * v;
              double side = 2 * u - 1;
              return new Vector3d(
                  width * side,
                  0.17 + 0.2 * v - 0.05 * v * v * v,
                  out + 0.012 * side * side * (1 - v));
            })
        .turnY(degrees);
  }
}
