package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.modelling.Colour;
import org.selectiverenderer.modelling.Curve;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Part;

/** A glass of red wine: 20 steps of a wall outside and inside, and of the wine. */
final class Glass {
  private static final int SEGMENTS = 20;

  private Glass() {}

  static Model model() {
    Curve foot = Curve.of(0, 0.002, 0.034, 0, 0.034, 0.002, 0.008, 0.009, 0.0042, 0.02);
    Curve bowl =
        Curve.of(0.0042, 0.088, 0.02, 0.097, 0.035, 0.118, 0.039, 0.145, 0.0325, 0.2)
            .line(0.0315, 0.2);
    Curve inside = Curve.of(0.038, 0.145, 0.034, 0.119, 0.019, 0.099, 0, 0.096);
    Curve wine = Curve.of(0, 0.0965, 0.0185, 0.0995, 0.0335, 0.1195, 0.0368, 0.138, 0, 0.138);
    Look clear = Look.glossy(Colour.of(0.75, 0.8, 0.82)).transparent(0.68);
    Look red = Look.glossy(Colour.of(0.3, 0.02, 0.05));
    return Model.of(
        "glass",
        Part.of("wine", red, Lathe.solid(wine, SEGMENTS)).crease(50),
        Part.of("glass", clear, Lathe.solid(foot.then(bowl).then(inside), SEGMENTS)).crease(60));
  }
}
