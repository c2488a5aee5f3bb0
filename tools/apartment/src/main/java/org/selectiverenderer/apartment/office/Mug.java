package org.selectiverenderer.apartment.office;

import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A china mug of coffee, 0.1 m high, its handle to the right (thesis Fig 71). */
final class Mug {
  private static final int SEGMENTS = 64;

  private Mug() {}

  static ParametricModel model() {
    ProfileCurve profile =
        ProfileCurve.from(0, 0.003)
            .line(0.026, 0.003)
            .line(0.028, 0)
            .line(0.031, 0)
            .bezier(0.037, 0.001, 0.04, 0.006, 0.0405, 0.014, 6)
            .line(0.0415, 0.092)
            .arc(0.039, 0.092, 180, 6)
            .line(0.0365, 0.09)
            .line(0.0365, 0.016)
            .bezier(0.0365, 0.01, 0.032, 0.007, 0.026, 0.007, 5)
            .line(0, 0.007);
    ModelMaterial china = ModelMaterial.glossy(ModelColour.of(0.2, 0.4, 0.52));
    ModelMaterial coffee = ModelMaterial.glossy(ModelColour.of(0.19, 0.1, 0.05));
    return ModelPlacement.centred(
        ParametricModel.of(
            "mug",
            Part.of("body", china, Lathe.solid(profile, SEGMENTS), handle()),
            Part.of(
                "coffee",
                coffee,
                RoundSolidBuilder.cylinder(0.0368, 0.004, SEGMENTS).move(0, 0.074, 0))));
  }

  private static TriangleMesh handle() {
    Spine ear =
        Spine.smooth(
            7, 0.039, 0.08, 0, 0.055, 0.083, 0, 0.07, 0.071, 0, 0.07, 0.048, 0, 0.056, 0.026, 0,
            0.039, 0.02, 0);
    return Sweep.of(SimplePolygon.ellipse(0.0065, 0.0042, 18), ear);
  }
}
