package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** An open portable computer, 0.34 m wide (thesis Fig 71). */
final class Laptop {
  private static final double WIDTH = 0.34;
  private static final double DEPTH = 0.232;
  private static final double PITCH = 0.0198;
  private static final double TOP = 0.0185;
  private static final double LEAN = 13;

  private Laptop() {}

  static ParametricModel model() {
    ModelMaterial picture = Materials.lit(0.16, 0.36, 0.5);
    return ModelPlacement.centred(
        ParametricModel.of(
            "laptop",
            Part.of("base", Materials.SILVER, base()),
            Part.of("keyBed", Materials.BLACK, keyBed()),
            Part.of("keys", Materials.CHARCOAL, keys()),
            Part.of("touchPad", Materials.GREY, touchPad()),
            Part.of("hinges", Materials.GREY, hinge(-0.11), hinge(0.11)),
            Part.of("lid", Materials.SILVER, lifted(lid())),
            Part.of("bezel", Materials.BLACK, lifted(bezel())),
            Part.of("screen", picture, lifted(screen(0.302, 0.178, 0, 0, 0))),
            Part.of(
                "screenBar",
                Materials.lit(0.08, 0.13, 0.2),
                lifted(screen(0.302, 0.012, 0, -0.083, 1))),
            Part.of(
                "window",
                Materials.lit(0.88, 0.89, 0.9),
                lifted(screen(0.17, 0.11, 0.03, 0.01, 1))),
            Part.of(
                "title",
                Materials.lit(0.8, 0.45, 0.15),
                lifted(screen(0.17, 0.012, 0.03, 0.064, 2))),
            Part.of("writing", Materials.lit(0.3, 0.32, 0.35), lifted(writing())),
            Part.of("feet", Materials.RUBBER, feet())));
  }

  private static TriangleMesh base() {
    return ExtrudedSolid.plate(
            TOP - 0.002, 0.005, 6, SimplePolygon.roundedRectangle(WIDTH, DEPTH, 0.016, 10))
        .move(0, 0.002, 0);
  }

  private static TriangleMesh keyBed() {
    return ExtrudedSolid.plate(
            0.0012, 0.0005, 2, SimplePolygon.roundedRectangle(15 * PITCH + 0.006, 0.11, 0.004, 5))
        .move(0, TOP - 0.0008, -0.034);
  }

  private static TriangleMesh keys() {
    double depth = 0.0177;
    return KeyboardLayout.of(
            KeyboardLayout.MAIN,
            PITCH,
            depth,
            width -> BoxBuilder.bevelled(width - 0.0028, 0.0036, depth - 0.0026, 0.0018, 5))
        .move(-7.5 * PITCH, TOP - 0.0002, -0.034 - 3 * depth);
  }

  private static TriangleMesh touchPad() {
    return ExtrudedSolid.plate(
            0.001, 0.0004, 3, SimplePolygon.roundedRectangle(0.09, 0.06, 0.005, 8))
        .move(0, TOP - 0.0004, 0.066);
  }

  private static TriangleMesh hinge(double x) {
    return MeshOrientation.sideways(RoundSolidBuilder.roundedCylinder(0.006, 0.05, 0.0015, 4, 48))
        .move(x - 0.025, TOP + 0.001, -DEPTH / 2 + 0.002);
  }

  /** Rotates a mesh that stands upright on the hinges back by the screen's tilt. */
  private static TriangleMesh lifted(TriangleMesh mesh) {
    return mesh.turnX(-LEAN).move(0, TOP + 0.002, -DEPTH / 2 + 0.001);
  }

  private static TriangleMesh lid() {
    return ExtrudedSolid.bevelled(
            0.007, 0.0033, 6, SimplePolygon.roundedRectangle(WIDTH, 0.214, 0.014, 10))
        .move(0, 0.109, -0.004);
  }

  private static TriangleMesh bezel() {
    return ExtrudedSolid.bevelled(
            0.0022,
            0.0008,
            3,
            SimplePolygon.roundedRectangle(WIDTH - 0.008, 0.206, 0.011, 8),
            SimplePolygon.roundedRectangle(0.3, 0.176, 0.001, 2))
        .move(0, 0.109, 0.0022);
  }

  private static TriangleMesh screen(double width, double height, double x, double y, int layer) {
    return MeshOrientation.flat(width, height).move(x, 0.109 + y, 0.0032 + 0.0003 * layer);
  }

  private static TriangleMesh writing() {
    return MeshPatterns.row(screen(0.14, 0.005, 0.03, 0.042, 2), 6, 0, -0.014, 0);
  }

  private static TriangleMesh feet() {
    return MeshPatterns.corners(
        RoundSolidBuilder.roundedCylinder(0.008, 0.004, 0.0015, 3, 32), 0.145, 0.095);
  }
}
