package org.selectiverenderer.apartment.kitchen;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/**
 * A fluted glass saltcellar, two thirds full, with a knurled steel cap whose lid has seven holes,
 * 92 mm high.
 */
final class Saltcellar {
  private static final int FLUTES = 12;
  private static final int KNURLS = 26;

  private Saltcellar() {}

  static ParametricModel model() {
    return ParametricModel.of(
        "saltcellar",
        Part.of("cap", Materials.POLISHED_STEEL, cap(), lid()),
        Part.of(
            "holes",
            Materials.SOFT_BLACK,
            RoundSolidBuilder.cylinder(0.0125, 0.001, 48).move(0, 0.0892, 0)),
        Part.of("salt", ModelMaterial.matt(ModelColour.hex(0xF4F2EC)), salt(), grains()),
        Part.of("glass", Materials.GLASS, glass()));
  }

  /** Returns the glass, fluted outside and smooth inside. */
  private static TriangleMesh glass() {
    ProfileCurve outside =
        ProfileCurve.of(0, 0.003, 0.014, 0.0025)
            .spline(3, 0.018, 0, 0.0222, 0.0012, 0.0235, 0.005)
            .spline(5, 0.0225, 0.02, 0.0195, 0.045, 0.0172, 0.064, 0.0165, 0.071);
    ProfileCurve inside =
        ProfileCurve.from(0.0145, 0.071).spline(4, 0.0152, 0.064, 0.0174, 0.045, 0.0202, 0.02);
    ProfileCurve bottom =
        ProfileCurve.from(0.0205, 0.012).spline(4, 0.017, 0.0078, 0.009, 0.007, 0, 0.0075);
    return Lathe.solid(outside.then(inside).then(bottom), 12 * FLUTES)
        .deform(p -> isOutside(p) ? fluted(p) : p);
  }

  private static boolean isOutside(Vector3d p) {
    return ModelPlacement.fromAxis(p.x, p.z) > 0.0215 - 0.07 * Math.max(0, p.y - 0.012)
        && p.y < 0.066;
  }

  private static Vector3d fluted(Vector3d p) {
    double depth = 0.035 * Math.min(1, p.y / 0.006) * Math.min(1, (0.066 - p.y) / 0.012);
    double wave = Math.abs(DegreeMath.sin(FLUTES / 2.0 * DegreeMath.atan2(-p.z, p.x)));
    double factor = 1 - depth * (1 - wave);
    return p.set(p.x * factor, p.y, p.z * factor);
  }

  /** Returns the salt, whose upper side is a small heap. */
  private static TriangleMesh salt() {
    ProfileCurve heap =
        ProfileCurve.of(0.0168, 0.0081, 0.0195, 0.0125, 0.0196, 0.02, 0.0172, 0.042);
    return Lathe.surface(heap.spline(8, 0.012, 0.0432, 0.005, 0.046, 0, 0.0465), 48)
        .deform(p -> p.y > 0.041 ? p.add(0, 0.0005 * DegreeMath.sin(9e5 * p.x + 7e5 * p.z), 0) : p);
  }

  /** Returns coarse grains on the heap and on the glass. */
  private static TriangleMesh grains() {
    TriangleMesh grains = TriangleMesh.EMPTY;
    for (int i = 0; i < 46; i++) {
      double radius = 0.0155 * Math.sqrt((i + 0.5) / 46);
      double height = 0.0462 - 0.0035 * radius / 0.0155;
      TriangleMesh grain =
          RoundSolidBuilder.superellipsoid(0.0007, 0.0007, 0.0007, 6, 6, 4, 8).turnX(17 * i);
      grains = grains.append(grain.move(radius, height, 0).turnY(137.5 * i));
    }
    return grains;
  }

  /** Returns the cap's knurled skirt, which curves in to the lid. */
  private static TriangleMesh cap() {
    ProfileCurve profile =
        ProfileCurve.of(0.0155, 0.068, 0.0182, 0.068, 0.0188, 0.0686)
            .spline(8, 0.0186, 0.078)
            .spline(4, 0.0178, 0.0815, 0.0158, 0.0875, 0.0135, 0.0905, 0.0132, 0.0912)
            .line(0.0122, 0.0912)
            .line(0.0122, 0.088);
    return Lathe.solid(profile, 5 * KNURLS).deform(Saltcellar::knurled);
  }

  private static Vector3d knurled(Vector3d p) {
    if (p.y < 0.0684 || p.y > 0.079) {
      return p;
    }
    double factor = 1 + 0.02 * DegreeMath.cos(KNURLS * DegreeMath.atan2(-p.z, p.x));
    return p.set(p.x * factor, p.y, p.z * factor);
  }

  /** Returns the lid with seven round through holes. */
  private static TriangleMesh lid() {
    SimplePolygon[] holes = new SimplePolygon[7];
    for (int i = 0; i < 6; i++) {
      holes[i] = SimplePolygon.circle(0.0013, 20).move(0.0068, 0).turn(60 * i);
    }
    holes[6] = SimplePolygon.circle(0.0013, 20);
    return ExtrudedSolid.plate(0.0014, 0.0004, 3, SimplePolygon.circle(0.0124, 96), holes)
        .move(0, 0.0902, 0);
  }
}
