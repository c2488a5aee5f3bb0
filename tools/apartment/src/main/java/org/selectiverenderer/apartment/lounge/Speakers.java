package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/**
 * Two loudspeakers with a television's width between them. Each: a box (12 triangles), a woofer of
 * a rim (22) with a cone (11), a tweeter (2 * 8 + 8 = 24), 69 in all.
 */
final class Speakers {
  private static final double APART = 1.4;
  private static final double FRONT = 0.11;

  private Speakers() {}

  static ParametricModel model() {
    ProfileCurve rim = ProfileCurve.of(0.08, 0, 0.068, 0.014);
    ProfileCurve cone = ProfileCurve.of(0.068, 0.014, 0, 0.001);
    ProfileCurve dome = ProfileCurve.of(0.034, 0, 0.02, 0.012, 0, 0.018);
    ModelMaterial grey = ModelMaterial.satin(ModelColour.of(0.3, 0.3, 0.31));
    ModelMaterial dark = ModelMaterial.matt(ModelColour.of(0.1, 0.1, 0.11));
    return ModelPlacement.centred(
        ParametricModel.of(
            "speakers",
            Part.of("boxes", Materials.WALNUT, pair(BoxBuilder.plain(0.2, 0.34, 2 * FRONT))),
            Part.of("rims", grey, pair(atFront(Lathe.surface(rim, 11), 0.105))).crease(60),
            Part.of("cones", dark, pair(atFront(Lathe.surface(cone, 11), 0.105))).crease(60),
            Part.of("tweeters", grey, pair(atFront(Lathe.surface(dome, 8), 0.258))).crease(60)));
  }

  private static TriangleMesh atFront(TriangleMesh upright, double height) {
    return upright.turnX(90).move(0, height, FRONT);
  }

  private static TriangleMesh pair(TriangleMesh speaker) {
    return MeshPatterns.bothSides(speaker.move(APART / 2, 0, 0));
  }
}
