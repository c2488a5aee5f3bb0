package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A steel saucepan, 0.2 m wide, with its lid on and a long black handle to the right. */
final class Saucepan {

  private Saucepan() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        "saucepan",
        Part.of("pan", Materials.POLISHED_STEEL, pan(), lid(), bracket()),
        Part.of("grips", Materials.SOFT_BLACK, handle(), knob()));
  }

  private static TriangleMesh pan() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0, 0.088, 0)
            .spline(4, 0.0955, 0.003, 0.099, 0.011)
            .line(0.1, 0.04)
            .line(0.1, 0.107)
            .spline(3, 0.1015, 0.111, 0.1048, 0.1128, 0.1035, 0.1148, 0.099, 0.113)
            .line(0.0975, 0.107)
            .line(0.0972, 0.014)
            .spline(3, 0.094, 0.006, 0.086, 0.004)
            .line(0, 0.004);
    return Lathe.solid(profile, 52);
  }

  /** Returns a domed lid with a flange that lies on the pan's rim. */
  private static TriangleMesh lid() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0.1315, 0.05, 0.128, 0.09, 0.1165, 0.104, 0.1148)
            .spline(2, 0.1062, 0.1158, 0.104, 0.1172)
            .line(0.094, 0.1182)
            .spline(4, 0.088, 0.1215, 0.06, 0.13, 0.025, 0.1345, 0, 0.135);
    return Lathe.solid(profile, 48);
  }

  private static TriangleMesh knob() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0.134, 0.012, 0.134, 0.0095, 0.142)
            .spline(3, 0.019, 0.149, 0.0205, 0.155, 0.014, 0.1595, 0, 0.16);
    return Lathe.solid(profile, 28);
  }

  /** Returns the steel bracket between pan and grip, held by two rivets. */
  private static TriangleMesh bracket() {
    TriangleMesh rivet =
        RoundSolidBuilder.ellipsoid(0.0035, 0.0035, 0.0035, 5, 10).move(0.0995, 0.088, 0);
    return Sweep.of(
            SimplePolygon.superellipse(0.013, 0.0045, 4, 16),
            Spine.smooth(4, 0.0985, 0.088, 0, 0.113, 0.089, 0, 0.134, 0.096, 0, 0.15, 0.1, 0),
            t -> 1.15 - 0.3 * t)
        .append(rivet.move(0, 0, 0.0075).append(rivet.move(0, 0, -0.0075)));
  }

  /** Returns the grip, thickest where the hand holds it, round at its end. */
  private static TriangleMesh handle() {
    return Sweep.of(
        SimplePolygon.superellipse(1, 0.72, 3, 20),
        Spine.smooth(
            4, 0.136, 0.0963, 0, 0.15, 0.1, 0, 0.2, 0.1125, 0, 0.25, 0.121, 0, 0.29, 0.125, 0,
            0.302, 0.126, 0, 0.306, 0.1262, 0),
        Saucepan::thickness);
  }

  private static double thickness(double t) {
    double end = Math.max(0, (t - 0.8) / 0.202);
    return (0.012 + 0.005 * t) * Math.sqrt(1 - end * end);
  }
}
