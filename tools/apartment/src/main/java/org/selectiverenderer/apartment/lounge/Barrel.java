package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/** A wooden barrel with four hoops, 0.6 m high; nobody expects it in a lounge. */
final class Barrel {
  private static final double HEIGHT = 0.6;
  private static final int STAVES = 18;

  private Barrel() {}

  static ParametricModel model() {
    ModelMaterial oak = ModelMaterial.satin(ModelColour.of(0.55, 0.36, 0.19));
    ModelMaterial iron = ModelMaterial.metal(ModelColour.of(0.45, 0.45, 0.47));
    return ParametricModel.of(
        "barrel",
        Part.of("staves", oak, staves()).crease(12),
        Part.of("hoops", iron, hoop(0.03, 0.07), hoop(0.16, 0.2), hoop(0.4, 0.44), hoop(0.53, 0.57))
            .crease(25));
  }

  /** Returns the radius at a height; the staves are bowed. */
  private static double radius(double y) {
    double t = 2 * y / HEIGHT - 1;
    return 0.25 - 0.055 * t * t;
  }

  private static TriangleMesh staves() {
    ProfileCurve profile = ProfileCurve.from(radius(0), 0);
    for (int i = 1; i <= 6; i++) {
      double y = HEIGHT * i / 6;
      profile = profile.line(radius(y), y);
    }
    double rim = radius(HEIGHT);
    return Lathe.solid(profile.line(rim - 0.02, HEIGHT).line(rim - 0.024, HEIGHT - 0.03), STAVES);
  }

  /** Returns a hoop that follows the staves three millimetres outside of them. */
  private static TriangleMesh hoop(double low, double high) {
    double below = radius(low);
    double above = radius(high);
    ProfileCurve profile =
        ProfileCurve.of(below + 0.003, low, above + 0.003, high, above - 0.004, high);
    return Lathe.surface(profile, STAVES);
  }
}
