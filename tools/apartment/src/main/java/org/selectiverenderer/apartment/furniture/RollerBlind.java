package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;

/** A blind rolled up above a window, with a hand's breadth of cloth and a cord. */
final class RollerBlind {
  private RollerBlind() {}

  /**
   * @param width metres
   */
  static ParametricModel model(String name, double width) {
    TriangleMesh roll =
        RoundSolidBuilder.cylinder(0.032, width, 8).turnZ(90).move(width / 2, 0.1, 0.032);
    TriangleMesh cloth = BoxBuilder.plain(width - 0.02, 0.1, 0.004).move(0, 0, 0.062);
    TriangleMesh bar = BoxBuilder.plain(width - 0.02, 0.018, 0.014).move(0, -0.018, 0.062);
    TriangleMesh cord = BoxBuilder.plain(0.005, 0.75, 0.005).move(width / 2 - 0.03, -0.66, 0.032);
    return ParametricModel.of(
        name,
        Part.of("cloth", Materials.CREAM_CLOTH, roll, cloth),
        Part.of("fittings", Materials.WHITE, bar, cord));
  }
}
