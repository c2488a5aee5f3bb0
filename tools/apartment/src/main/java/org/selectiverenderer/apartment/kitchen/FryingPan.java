package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A black frying pan, 0.26 m wide, with a wooden handle to the front right. */
final class FryingPan {

  private FryingPan() {}

  static ParametricModel model() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0, 0.098, 0, 0.108, 0.006)
            .line(0.13, 0.044)
            .line(0.1315, 0.047)
            .line(0.128, 0.047)
            .line(0.1055, 0.009)
            .line(0.097, 0.004)
            .line(0, 0.004);
    return ModelPlacement.centred(
        "fryingPan",
        Part.of("pan", Materials.SOFT_BLACK, Lathe.solid(profile, 26)),
        Part.of("bracket", Materials.POLISHED_STEEL, bracket().turnY(-35)),
        Part.of("handle", Materials.DARK_WOOD, handle().turnY(-35)));
  }

  private static TriangleMesh bracket() {
    return Sweep.of(
        SimplePolygon.rectangle(0.022, 0.007),
        Spine.of(0.125, 0.036, 0, 0.15, 0.044, 0, 0.185, 0.056, 0));
  }

  private static TriangleMesh handle() {
    Spine line =
        Spine.of(
            0.17, 0.051, 0, 0.19, 0.0575, 0, 0.24, 0.07, 0, 0.3, 0.079, 0, 0.33, 0.081, 0, 0.338,
            0.0812, 0);
    return Sweep.of(SimplePolygon.ellipse(0.014, 0.01, 10), line, t -> 0.85 + 0.6 * t * (1.15 - t));
  }
}
