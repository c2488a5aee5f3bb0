package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Copies;
import org.selectiverenderer.modelling.Curve;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Standing;

/**
 * Two loudspeakers with a television's width between them. Each: a box (12 triangles), a woofer of
 * a rim (22) with a cone (11), a tweeter (2 * 8 + 8 = 24), 69 in all.
 */
final class Speakers {
  private static final double APART = 1.4;
  private static final double FRONT = 0.11;

  private Speakers() {}

  static ParametricModel model() {
    Curve rim = Curve.of(0.08, 0, 0.068, 0.014);
    Curve cone = Curve.of(0.068, 0.014, 0, 0.001);
    Curve dome = Curve.of(0.034, 0, 0.02, 0.012, 0, 0.018);
    Look grey = Look.satin(ModelColour.of(0.3, 0.3, 0.31));
    Look dark = Look.matt(ModelColour.of(0.1, 0.1, 0.11));
    return Standing.centred(
        ParametricModel.of(
            "speakers",
            Part.of("boxes", Looks.WALNUT, pair(Boxes.plain(0.2, 0.34, 2 * FRONT))),
            Part.of("rims", grey, pair(atFront(Lathe.surface(rim, 11), 0.105))).crease(60),
            Part.of("cones", dark, pair(atFront(Lathe.surface(cone, 11), 0.105))).crease(60),
            Part.of("tweeters", grey, pair(atFront(Lathe.surface(dome, 8), 0.258))).crease(60)));
  }

  private static TriangleMesh atFront(TriangleMesh upright, double height) {
    return upright.turnX(90).move(0, height, FRONT);
  }

  private static TriangleMesh pair(TriangleMesh speaker) {
    return Copies.bothSides(speaker.move(APART / 2, 0, 0));
  }
}
