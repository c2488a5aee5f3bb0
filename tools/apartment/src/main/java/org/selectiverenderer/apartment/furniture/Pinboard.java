package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A board of cork in a frame of oak, 0.9 m by 0.6 m, with notes pinned to it. */
final class Pinboard {
  private static final double WIDTH = 0.9;
  private static final double HEIGHT = 0.6;
  private static final double FACE = 0.01;

  private Pinboard() {}

  static ParametricModel model() {
    SimplePolygon section = SimplePolygon.rectangle(0.018, 0.03).move(0.009, 0);
    TriangleMesh frame =
        Sweep.of(section, Spine.of(SimplePolygon.rectangle(WIDTH - 0.03, HEIGHT - 0.03)));
    TriangleMesh cork =
        BoxBuilder.plain(WIDTH - 0.03, HEIGHT - 0.03, FACE).move(0, -HEIGHT / 2 + 0.015, FACE / 2);
    return ParametricModel.of(
        "pinboard",
        Part.of("frame", Materials.LIGHT_OAK, frame),
        Part.of("cork", colour(0.68, 0.5, 0.32), cork),
        Part.of(
            "sheets",
            Materials.PAPER,
            note(0.21, 0.297, -4).move(-0.26, 0.07, 0),
            note(0.21, 0.297, 3).move(0.02, -0.06, 0)),
        Part.of("yellowNotes", colour(0.93, 0.82, 0.34), note(0.1, 0.1, 5).move(0.24, 0.16, 0)),
        Part.of("pinkNotes", colour(0.88, 0.5, 0.52), note(0.1, 0.1, -7).move(0.33, -0.02, 0)),
        Part.of("blueNotes", colour(0.5, 0.66, 0.8), note(0.1, 0.07, 2).move(-0.22, -0.19, 0)));
  }

  private static TriangleMesh note(double width, double height, double degrees) {
    return ParametricSurface.field(width, height, 1, 1, (x, z) -> 0)
        .turnX(90)
        .turnZ(degrees)
        .move(0, 0, FACE + 0.002);
  }

  private static ModelMaterial colour(double red, double green, double blue) {
    return ModelMaterial.matt(ModelColour.of(red, green, blue));
  }
}
