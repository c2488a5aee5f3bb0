package org.selectiverenderer.apartment.lounge;

import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A burning candle in a brass candlestick with a ring to carry it by; wax has run down it. */
final class Candle {
  private static final double RADIUS = 0.0235;
  private static final double TOP = 0.17;

  /** A run of wax: its angle about the candle, its lower end and its width; degrees and metres. */
  private record Drip(double angle, double end, double width) {}

  private static final List<Drip> DRIPS =
      List.of(
          new Drip(-115, 0.075, 15),
          new Drip(-80, 0.128, 11),
          new Drip(-38, 0.052, 16),
          new Drip(15, 0.11, 12),
          new Drip(70, 0.084, 15),
          new Drip(125, 0.118, 13),
          new Drip(172, 0.064, 14));

  private Candle() {}

  static ParametricModel model() {
    ModelMaterial wax =
        new ModelMaterial(
            ModelColour.of(0.9, 0.84, 0.68), ModelColour.grey(0.2), 0.2, 0, ModelColour.grey(0.06));
    ModelMaterial flame =
        ModelMaterial.matt(ModelColour.of(1, 0.7, 0.2)).glowing(ModelColour.of(1, 0.62, 0.16));
    Part body = Part.of("wax", wax, wax()).crease(70);
    return ModelPlacement.centred(
        ParametricModel.of(
            "candle",
            Part.of("holder", Materials.PALE_BRASS, dish(), handle()),
            body,
            Part.of("wick", Materials.BLACK_PLASTIC, wick()),
            Part.of("flame", flame, flame()).crease(90)));
  }

  private static TriangleMesh wax() {
    ProfileCurve profile =
        ProfileCurve.from(0, 0.008)
            .line(RADIUS, 0.008)
            .spline(46, RADIUS, TOP - 0.003)
            .arc(RADIUS - 0.003, TOP - 0.003, 90, 4)
            .spline(4, 0.015, TOP - 0.007, 0, TOP - 0.009);
    return Lathe.solid(profile, 64).deform(Candle::runWax);
  }

  /** Moves a point of the plain candle out to the surface of the runs of wax. */
  private static Vector3d runWax(Vector3d p) {
    double radius = Math.sqrt(p.x * p.x + p.z * p.z);
    if (radius < 0.018 || p.y < 0.01) {
      return p;
    }
    double angle = DegreeMath.atan2(p.x, p.z);
    double thick = 0;
    for (Drip drip : DRIPS) {
      double off = Math.abs(angle - drip.angle);
      double across = Math.min(off, 360 - off) / drip.width;
      double along = (p.y - drip.end) / 0.008;
      // A thin run, and a fat drop at its end.
      double drop = 0.0042 / (1 + across * across + along * along);
      double run = along > 0 ? 0.0028 / (1 + across * across * across * across) : 0;
      thick = Math.max(thick, across < 2 ? Math.max(drop, run) - 0.0006 : 0);
    }
    double factor = 1 + Math.max(0, thick) / radius;
    return p.mul(factor, 1, factor);
  }

  private static TriangleMesh dish() {
    ProfileCurve profile =
        ProfileCurve.from(0, 0.001)
            .line(0.045, 0)
            .spline(4, 0.06, 0.004, 0.068, 0.016)
            .arc(0.067, 0.017, 180, 4)
            .spline(3, 0.056, 0.0065, 0.04, 0.005)
            .line(0.03, 0.006)
            .spline(3, 0.0275, 0.012, 0.029, 0.026)
            .line(0.0265, 0.0265)
            .line(0.0245, 0.012)
            .line(0, 0.0115);
    return Lathe.solid(profile, 26);
  }

  private static TriangleMesh handle() {
    Spine ring = Spine.of(SimplePolygon.circle(0.019, 20).move(0.0855, 0.02));
    return Sweep.of(SimplePolygon.ellipse(0.0028, 0.0028, 8), ring);
  }

  private static TriangleMesh wick() {
    Spine line =
        Spine.smooth(4, 0, TOP - 0.011, 0, 0.0005, TOP - 0.004, 0, 0.0025, TOP + 0.003, 0.001);
    return Sweep.tube(line, 0.0012, 8);
  }

  private static TriangleMesh flame() {
    ProfileCurve drop =
        ProfileCurve.from(0, 0)
            .spline(3, 0.0058, 0.006, 0.0075, 0.013, 0.0048, 0.026, 0.0018, 0.037, 0, 0.044);
    return Lathe.solid(drop, 12).move(0.0015, TOP - 0.002, 0);
  }
}
