package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/**
 * A computer mouse with its cable laid in a bow, 0.12 m long, its buttons to the front and the left
 * (thesis Fig 71).
 */
final class LibraryMouse {

  private LibraryMouse() {}

  static ParametricModel model() {
    MouseShape shape = new MouseShape(54, 72);
    TriangleMesh cable =
        shape.cable(
            9, 10, 0.02, 0.003, 0.09, 0.06, 0.003, 0.085, 0.075, 0.003, 0.045, 0.068, 0.003, -0.01,
            0.055, 0.003, -0.06);
    ParametricModel mouse =
        ParametricModel.of(
            "libraryMouse",
            Part.of("palm", Materials.SILVER, shape.palm()).crease(60),
            Part.of("buttons", Materials.GREY, shape.buttons()).crease(60),
            Part.of("seam", Materials.BLACK, shape.seam(24)),
            Part.of("wheel", Materials.CHARCOAL, shape.wheel(40, 16)),
            Part.of("cable", Materials.CHARCOAL, cable));
    return ModelPlacement.centred(mouse.map(mesh -> mesh.turnY(-40)));
  }
}
