package org.selectiverenderer.apartment.kitchen;

import org.joml.Vector3d;
import org.selectiverenderer.modelling.Copies;
import org.selectiverenderer.modelling.Curve;
import org.selectiverenderer.modelling.Degrees;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.TriangleMesh;

/**
 * A stack of eight plates, five white ones and three smaller blue ones, whose brims are fluted
 * between two beads: 192 steps of a profile with 40 bands each.
 */
final class Plates {
  private static final int SEGMENTS = 192;
  private static final int FLUTES = 48;

  /** How far the next plate of a stack lies above the one below. */
  private static final double STEP = 0.0075;

  private Plates() {}

  static Model model() {
    TriangleMesh large = plate();
    TriangleMesh small = large.scale(0.76, 1, 0.76).turnY(7);
    return Standing.centred(
        "plates",
        Part.of("dinnerPlates", Palette.CHINA, Copies.row(large, 5, 0, STEP, 0)),
        Part.of("dessertPlates", Palette.BLUE_CHINA, Copies.row(small, 3, 0, STEP, 0).move(0, 5 * STEP, 0)));
  }

  /** 0.26 m wide: foot ring, brim with a relief, flat middle. */
  private static TriangleMesh plate() {
    Curve under =
        Curve.of(0, 0.003, 0.04, 0.003, 0.066, 0.003, 0.069, 0.0022)
            .line(0.07, 0.0004)
            .line(0.0708, 0)
            .line(0.073, 0)
            .line(0.0745, 0.0025)
            .spline(3, 0.09, 0.0085, 0.11, 0.0155, 0.128, 0.0195);
    Curve edge = Curve.from(0.1295, 0.0203).arc(0.1285, 0.0212, 150, 4);
    Curve brim =
        Curve.from(0.1262, 0.0212)
            .spline(1, 0.1248, 0.0222, 0.1234, 0.0212, 0.1222, 0.0208)
            .spline(2, 0.117, 0.0199, 0.111, 0.0188, 0.105, 0.0175)
            .spline(1, 0.1036, 0.0184, 0.1022, 0.0172);
    Curve middle =
        Curve.from(0.098, 0.0152).spline(2, 0.086, 0.0096, 0.076, 0.0068, 0.066, 0.006).line(0, 0.0058);
    return Lathe.solid(under.then(edge).then(brim).then(middle), SEGMENTS).deform(Plates::waved);
  }

  /** The brim's upper side is fluted; its line stays round. */
  private static Vector3d waved(Vector3d p) {
    double radius = Math.hypot(p.x, p.z);
    double share = Math.max(0, 1 - Math.abs(radius - 0.1128) / 0.0105);
    boolean above = p.y > 0.0168 + 0.19 * (radius - 0.1022);
    double wave = 1 - Math.abs(Degrees.sin(FLUTES / 2.0 * Degrees.atan2(-p.z, p.x)));
    return above ? p.add(0, -0.0005 * share * wave, 0) : p;
  }
}
