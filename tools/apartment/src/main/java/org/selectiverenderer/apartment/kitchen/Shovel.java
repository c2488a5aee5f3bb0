package org.selectiverenderer.apartment.kitchen;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * A garden shovel, 1.1 m long, on the tip of its blade and leaning back by 12 degrees, for a wall
 * behind it. One of the objects that no kitchen is expected to have (thesis, Appendix B).
 */
final class Shovel {
  private static final double LEAN = -12;

  private Shovel() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        "shovel",
        Part.of("blade", Materials.DARK_STEEL, blade().turnX(LEAN), socket().turnX(LEAN))
            .crease(40),
        Part.of("shaft", Materials.LIGHT_OAK, shaft().turnX(LEAN)),
        Part.of("grip", Materials.BRICK_RED, grip().turnX(LEAN)));
  }

  /** Returns the concave blade, pointed below, with straight shoulders. */
  private static TriangleMesh blade() {
    TriangleMesh sheet =
        ParametricSurface.of(
            6,
            6,
            (u, v) -> {
              double x = 2 * u - 1;
              double width = 0.1 * Math.sqrt(Math.min(1, 0.02 + 1.7 * v));
              double y = 0.3 * v;
              return new Vector3d(
                  width * x, y, 0.035 * x * x * (0.4 + 0.6 * v) - 0.02 * (1 - v) * v);
            });
    return ParametricSurface.thicken(sheet, 0, 0, -0.003);
  }

  private static TriangleMesh socket() {
    ProfileCurve profile =
        ProfileCurve.of(0.006, 0.14, 0.016, 0.26, 0.02, 0.31, 0.02, 0.42, 0.017, 0.42);
    return Lathe.solid(profile, 10);
  }

  private static TriangleMesh shaft() {
    return Sweep.tube(Spine.of(0, 0.4, 0, 0, 0.7, 0, 0, 0.97, 0), 0.0165, 10);
  }

  /** Returns the D-shaped grip. */
  private static TriangleMesh grip() {
    Spine d =
        Spine.loop(
            0, 0.965, 0, 0.03, 0.99, 0, 0.055, 1.03, 0, 0.06, 1.075, 0, 0.05, 1.085, 0, 0, 1.087, 0,
            -0.05, 1.085, 0, -0.06, 1.075, 0, -0.055, 1.03, 0, -0.03, 0.99, 0);
    return Sweep.tube(d, 0.0125, 7);
  }
}
