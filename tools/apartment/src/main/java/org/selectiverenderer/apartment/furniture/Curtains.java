package org.selectiverenderer.apartment.furniture;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;

/** Two long curtains of linen drawn to the sides of a window, on a rail; their middle is x = 0. */
final class Curtains {
  private static final double PANEL = 0.38;
  private static final double LENGTH = 2.34;
  private static final int FOLDS = 4;

  /** Distance of the rail and of the cloth from the wall, metres. */
  private static final double AWAY = 0.075;

  /** Distance by which the window's sill is wider on each side, metres. */
  private static final double SILL = 0.09;

  private Curtains() {}

  /**
   * @param window width of the window between its reveals, metres
   */
  static ParametricModel model(String name, double window) {
    double middle = window / 2 + SILL + PANEL / 2;
    double rail = 2 * middle + PANEL + 0.05;
    TriangleMesh bar =
        RoundSolidBuilder.cylinder(0.011, rail, 6).turnZ(90).move(rail / 2, LENGTH, AWAY);
    TriangleMesh bracket =
        BoxBuilder.plain(0.02, 0.03, AWAY).move(window / 2 + SILL / 2, LENGTH - 0.013, AWAY / 2);
    return ParametricModel.of(
        name,
        Part.of("cloth", Materials.LINEN, MeshPatterns.bothSides(panel().move(middle, 0, AWAY)))
            .crease(180),
        Part.of("rail", Materials.DARK_STEEL, bar, MeshPatterns.bothSides(bracket)));
  }

  /** Returns a curtain whose folds are wider at the hem than at the rail. */
  private static TriangleMesh panel() {
    return ParametricSurface.of(
        4 * FOLDS,
        1,
        (u, v) ->
            new Vector3d(
                (u - 0.5) * (PANEL - 0.05 * v),
                v * LENGTH,
                (0.042 - 0.022 * v) * DegreeMath.sin(360.0 * FOLDS * u)));
  }
}
