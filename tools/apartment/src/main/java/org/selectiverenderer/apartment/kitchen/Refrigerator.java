package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A white refrigerator, 1.78 m high, with the freezer below and a note held by two magnets. */
final class Refrigerator {
  private static final double WIDTH = 0.6;
  private static final double FRONT = 0.345;

  private Refrigerator() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        "refrigerator",
        Part.of(
            "cabinet",
            ModelMaterial.satin(ModelColour.hex(0xDCDCD6)),
            BoxBuilder.plain(0.594, 1.735, 0.56).move(0, 0.04, 0)),
        Part.of(
            "doors",
            ModelMaterial.glossy(ModelColour.hex(0xECECE6)),
            door(0.05, 0.62),
            door(0.675, 1.105)),
        Part.of("feet", Materials.SOFT_BLACK, BoxBuilder.plain(0.56, 0.04, 0.5)),
        Part.of("handles", Materials.POLISHED_STEEL, handle(0.46), handle(0.86)),
        Part.of(
            "note",
            ModelMaterial.matt(ModelColour.hex(0xF1E7B8)),
            BoxBuilder.plain(0.1, 0.13, 0.002).move(0.09, 1.24, FRONT)),
        Part.of("magnets", Materials.BRICK_RED, magnet(0.09, 1.36), magnet(0.02, 1.44)));
  }

  private static TriangleMesh door(double y, double height) {
    return RoundedSlabs.upright(
            SimplePolygon.roundedRectangle(WIDTH, height, 0.022, 2), 0.065, 0.014, 2)
        .move(0, y + height / 2, FRONT - 0.065);
  }

  /** Returns an upright bow handle, centred at this height. */
  private static TriangleMesh handle(double y) {
    Spine line =
        Spine.of(
            0, -0.13, 0, 0, -0.128, 0.026, 0, -0.11, 0.042, 0, 0, 0.048, 0, 0.11, 0.042, 0, 0.128,
            0.026, 0, 0.13, 0);
    return Sweep.of(SimplePolygon.ellipse(0.007, 0.011, 8), line).move(-0.255, y, FRONT);
  }

  private static TriangleMesh magnet(double x, double y) {
    return RoundSolidBuilder.cone(0.014, 0.012, 0.008, 12).turnX(90).move(x, y, FRONT);
  }
}
