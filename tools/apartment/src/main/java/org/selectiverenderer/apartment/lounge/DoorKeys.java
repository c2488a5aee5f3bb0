package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** Three keys and a leather fob on a ring, lying fanned out. */
final class DoorKeys {
  private static final double RING = 0.014;

  private DoorKeys() {}

  static ParametricModel model() {
    ModelMaterial leather = ModelMaterial.satin(ModelColour.of(0.42, 0.17, 0.1));
    Part steel =
        Part.of(
            "steelKeys",
            Materials.STEEL,
            onRing(key(0.052), 62, 0.001),
            onRing(key(0.045), 8, 0.004));
    return ModelPlacement.centred(
        ParametricModel.of(
            "keys",
            Part.of(
                "ring",
                Materials.STEEL,
                RoundSolidBuilder.torus(RING, 0.0011, 22, 6).turnZ(5).move(0, 0.003, 0)),
            steel,
            Part.of("brassKey", Materials.PALE_BRASS, onRing(key(0.048), 34, 0.0025)),
            Part.of("fob", leather, onRing(fob(), 160, 0.0012))));
  }

  /** Rotates a mesh that points to +x outwards from the ring, its hole on the ring. */
  private static TriangleMesh onRing(TriangleMesh thing, double degrees, double height) {
    return thing.turnZ(-2).move(RING, height, 0).turnY(degrees);
  }

  /** Returns a key: a round bow with a hole, and a blade with bits on one side. */
  private static TriangleMesh key(double length) {
    double s = length - 0.02;
    SimplePolygon shape =
        ProfileCurve.from(0.0155, -0.0028)
            .line(length, -0.0028)
            .line(length + 0.003, 0.0005)
            .line(length, 0.0022)
            .line(0.02 + 0.85 * s, 0.0005)
            .line(0.02 + 0.7 * s, 0.0028)
            .line(0.02 + 0.55 * s, 0.0008)
            .line(0.02 + 0.4 * s, 0.0028)
            .line(0.02 + 0.25 * s, 0.0012)
            .line(0.02 + 0.15 * s, 0.0028)
            .line(0.0155, 0.0028)
            .arc(0.0055, 0, 328, 18)
            .closed();
    return ExtrudedSolid.plate(0.0022, 0.0004, 1, shape, SimplePolygon.circle(0.0032, 10));
  }

  private static TriangleMesh fob() {
    SimplePolygon drop =
        SimplePolygon.spline(
            4, -0.008, 0, 0, -0.0075, 0.024, -0.0145, 0.043, -0.011, 0.05, 0, 0.043, 0.011, 0.024,
            0.0145, 0, 0.0075);
    return ExtrudedSolid.plate(0.0036, 0.0012, 1, drop, SimplePolygon.circle(0.003, 10));
  }
}
