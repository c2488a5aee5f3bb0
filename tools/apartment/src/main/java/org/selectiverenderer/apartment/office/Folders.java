package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;

/** Four lever-arch files that stand beside each other, 0.31 m high; one version. */
final class Folders {
  private static final double WIDTH = 0.075;
  private static final double HEIGHT = 0.31;
  private static final double DEPTH = 0.27;

  private Folders() {}

  static ParametricModel model() {
    TriangleMesh file = BoxBuilder.bevelled(WIDTH - 0.002, HEIGHT, DEPTH, 0.003, 1);
    TriangleMesh label = MeshOrientation.flat(0.05, 0.13).move(0, 0.2, DEPTH / 2 + 0.0008);
    TriangleMesh lines = MeshPatterns.row(MeshOrientation.flat(0.036, 0.006), 3, 0, -0.02, 0);
    TriangleMesh hole = MeshOrientation.forward(RoundSolidBuilder.cylinder(0.012, 0.002, 6));
    return ModelPlacement.centred(
        ParametricModel.of(
            "folders",
            Part.of("greenFiles", Materials.GREEN, file, file.move(WIDTH, 0, 0)),
            Part.of("blackFile", Materials.CHARCOAL, file.move(2 * WIDTH, 0, 0)),
            Part.of("blueFile", Materials.BLUE, file.move(3 * WIDTH, 0, 0)),
            Part.of("labels", Materials.PAPER, MeshPatterns.row(label, 4, WIDTH, 0, 0)),
            Part.of("writing", Materials.BLACK, row(lines.move(0, 0.24, DEPTH / 2 + 0.0014))),
            Part.of("holes", Materials.CHROME, row(hole.move(0, 0.06, DEPTH / 2 - 0.001)))));
  }

  private static TriangleMesh row(TriangleMesh mesh) {
    return MeshPatterns.row(mesh, 4, WIDTH, 0, 0);
  }
}
