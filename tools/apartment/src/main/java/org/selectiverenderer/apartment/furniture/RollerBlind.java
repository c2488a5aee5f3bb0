package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Rounds;

/** A blind rolled up above a window, 2 m wide, with a hand's breadth of cloth and a cord. */
final class RollerBlind {
  private static final double WIDTH = 2;

  private RollerBlind() {}

  static ParametricModel model() {
    TriangleMesh roll = Rounds.cylinder(0.032, WIDTH, 8).turnZ(90).move(WIDTH / 2, 0.1, 0.032);
    TriangleMesh cloth = Boxes.plain(WIDTH - 0.02, 0.1, 0.004).move(0, 0, 0.062);
    TriangleMesh bar = Boxes.plain(WIDTH - 0.02, 0.018, 0.014).move(0, -0.018, 0.062);
    TriangleMesh cord = Boxes.plain(0.005, 0.75, 0.005).move(WIDTH / 2 - 0.03, -0.66, 0.032);
    return ParametricModel.of(
        "rollerBlind",
        Part.of("cloth", Looks.CREAM_CLOTH, roll, cloth),
        Part.of("fittings", Looks.WHITE, bar, cord));
  }
}
