package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.SimplePolygon;

/** A stapler, 0.14 m long, seen from its side, its mouth to the right; one version. */
final class Stapler {

  private Stapler() {}

  static ParametricModel model() {
    SimplePolygon base =
        SimplePolygon.of(
            -0.07, 0, 0.072, 0, 0.072, 0.008, -0.03, 0.011, -0.045, 0.026, -0.07, 0.026);
    SimplePolygon arm =
        SimplePolygon.of(
            -0.072, 0.026, -0.062, 0.042, -0.03, 0.05, 0.03, 0.05, 0.066, 0.043, 0.07, 0.03, 0.06,
            0.029, -0.045, 0.026);
    return ModelPlacement.centred(
        ParametricModel.of(
            "stapler",
            Part.of("base", Materials.CHARCOAL, slab(base, 0.032)),
            Part.of("arm", Materials.RED, slab(arm, 0.028)),
            Part.of("magazine", Materials.CHROME, magazine(), anvil())));
  }

  private static TriangleMesh slab(SimplePolygon side, double width) {
    return ExtrudedSolid.bevelled(width, 0.002, 1, side).move(0, 0, -width / 2);
  }

  private static TriangleMesh magazine() {
    return BoxBuilder.plain(0.1, 0.008, 0.016).move(0.017, 0.0235, 0);
  }

  private static TriangleMesh anvil() {
    return BoxBuilder.plain(0.016, 0.003, 0.018).move(0.058, 0.0075, 0);
  }
}
