package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Copies;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Rounds;
import org.selectiverenderer.modelling.Standing;

/** Four lever-arch files that stand beside each other, 0.31 m high; one version. */
final class Folders {
  private static final double WIDTH = 0.075;
  private static final double HEIGHT = 0.31;
  private static final double DEPTH = 0.27;

  private Folders() {}

  static ParametricModel model() {
    TriangleMesh file = Boxes.bevelled(WIDTH - 0.002, HEIGHT, DEPTH, 0.003, 1);
    TriangleMesh label = Placing.flat(0.05, 0.13).move(0, 0.2, DEPTH / 2 + 0.0008);
    TriangleMesh lines = Copies.row(Placing.flat(0.036, 0.006), 3, 0, -0.02, 0);
    TriangleMesh hole = Placing.forward(Rounds.cylinder(0.012, 0.002, 6));
    return Standing.centred(
        ParametricModel.of(
            "folders",
            Part.of("greenFiles", Looks.GREEN, file, file.move(WIDTH, 0, 0)),
            Part.of("blackFile", Looks.CHARCOAL, file.move(2 * WIDTH, 0, 0)),
            Part.of("blueFile", Looks.BLUE, file.move(3 * WIDTH, 0, 0)),
            Part.of("labels", Looks.PAPER, Copies.row(label, 4, WIDTH, 0, 0)),
            Part.of("writing", Looks.BLACK, row(lines.move(0, 0.24, DEPTH / 2 + 0.0014))),
            Part.of("holes", Looks.CHROME, row(hole.move(0, 0.06, DEPTH / 2 - 0.001)))));
  }

  private static TriangleMesh row(TriangleMesh mesh) {
    return Copies.row(mesh, 4, WIDTH, 0, 0);
  }
}
