package org.selectiverenderer.apartment.kitchen;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** A hamburger with lettuce, tomato, cheese and sesame, 0.12 m wide, on a plate of 0.22 m. */
final class Hamburger {
  private static final ModelMaterial BUN = ModelMaterial.satin(ModelColour.hex(0xC58541));
  private static final ModelMaterial CRUMB = ModelMaterial.matt(ModelColour.hex(0xE9CF9A));
  private static final ModelMaterial MEAT = ModelMaterial.matt(ModelColour.hex(0x593722));
  private static final ModelMaterial CHEESE = ModelMaterial.satin(ModelColour.hex(0xEFB033));
  private static final ModelMaterial TOMATO = ModelMaterial.glossy(ModelColour.hex(0xBF3A2A));
  private static final ModelMaterial LETTUCE = ModelMaterial.satin(ModelColour.hex(0x76A23C));

  private Hamburger() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        "hamburger",
        Part.of("plate", Materials.CHINA, plate()),
        Part.of("bun", BUN, lowerBun(), crown()),
        Part.of("sesame", CRUMB, sesame()),
        Part.of("meat", MEAT, meat()),
        Part.of("cheese", CHEESE, cheese()),
        Part.of("tomato", TOMATO, tomato(-0.016, -0.012), tomato(0.017, 0.013)),
        Part.of("lettuce", LETTUCE, lettuce()).crease(60));
  }

  private static TriangleMesh plate() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0.003, 0.058, 0.003, 0.06, 0, 0.064, 0, 0.067, 0.003)
            .spline(4, 0.088, 0.0085, 0.108, 0.0145)
            .arc(0.107, 0.0172, 160, 4)
            .spline(4, 0.088, 0.0135, 0.066, 0.0078, 0.055, 0.007)
            .line(0, 0.007);
    return Lathe.solid(profile, 60);
  }

  private static TriangleMesh lowerBun() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0.006, 0.046, 0.006)
            .spline(5, 0.055, 0.01, 0.0575, 0.017, 0.054, 0.0225)
            .line(0, 0.023);
    return Lathe.solid(profile, 60);
  }

  private static TriangleMesh crown() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0.05, 0.052, 0.05)
            .spline(
                6, 0.0585, 0.0535, 0.0585, 0.062, 0.05, 0.077, 0.032, 0.089, 0.013, 0.0935, 0,
                0.094);
    return Lathe.solid(profile, 54);
  }

  /** Returns sesame seeds on the crown, arranged like a sunflower's seeds (golden angle). */
  private static TriangleMesh sesame() {
    TriangleMesh seeds = TriangleMesh.EMPTY;
    TriangleMesh seed = RoundSolidBuilder.ellipsoid(0.0016, 0.0009, 0.0026, 5, 6);
    for (int i = 0; i < 48; i++) {
      double radius = 0.05 * Math.sqrt((i + 0.5) / 48);
      double rise = Math.sqrt(1 - square(radius / 0.0585));
      double slope = DegreeMath.atan2(0.032 * radius / 0.0585, 0.0585 * rise);
      seeds =
          seeds.append(
              seed.turnY(67 * i)
                  .turnZ(-slope)
                  .move(radius, 0.0625 + 0.032 * rise, 0)
                  .turnY(137.5 * i));
    }
    return seeds;
  }

  /** Returns the patty with a rough rim. */
  private static TriangleMesh meat() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0.0225, 0.05, 0.0225)
            .spline(6, 0.058, 0.026, 0.059, 0.031, 0.053, 0.0365)
            .line(0, 0.037);
    return Lathe.solid(profile, 96).deform(Hamburger::rough);
  }

  private static Vector3d rough(Vector3d p) {
    double angle = DegreeMath.atan2(-p.z, p.x);
    double lumps = DegreeMath.sin(17 * angle + 9e4 * p.y) + DegreeMath.sin(29 * angle - 7e4 * p.y);
    double factor = 1 + 0.011 * lumps;
    return p.set(p.x * factor, p.y, p.z * factor);
  }

  /** Returns a square slice of cheese whose corners hang over the meat. */
  private static TriangleMesh cheese() {
    return ParametricSurface.thicken(
            ParametricSurface.field(0.106, 0.106, 19, 19, Hamburger::drooping), 0, -0.0016, 0)
        .turnY(32);
  }

  private static double drooping(double x, double z) {
    double radius = ModelPlacement.fromAxis(x, z);
    return 0.0385 - 8 * square(Math.max(0, radius - 0.0535)) - 0.25 * Math.max(0, radius - 0.056);
  }

  private static double square(double x) {
    return x * x;
  }

  private static TriangleMesh tomato(double x, double z) {
    return RoundSolidBuilder.roundedCylinder(0.037, 0.0065, 0.002, 3, 44).move(x, 0.039, z);
  }

  /** Returns a lettuce leaf whose waves grow towards its edge. */
  private static TriangleMesh lettuce() {
    SimplePolygon round = SimplePolygon.circle(1, 140);
    TriangleMesh leaf =
        ParametricSurface.of(
            139,
            9,
            (u, v) -> {
              int i = (int) Math.round(139 * u);
              double out = 0.028 + 0.04 * v;
              double wave =
                  v * v * DegreeMath.sin(360 * 13 * u) + 0.4 * v * DegreeMath.sin(360 * 5 * u);
              double radius = out + 0.002 * v * DegreeMath.sin(360 * 7 * u);
              return new Vector3d(
                  radius * round.x(i), 0.047 + 0.0042 * wave - 0.006 * v * v, -radius * round.y(i));
            });
    return ParametricSurface.thicken(leaf, 0, 0.0009, 0);
  }
}
