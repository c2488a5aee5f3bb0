package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/** A low cupboard of oak with two sliding doors, 1.5 m by 0.75 m. */
final class Credenza {
  private static final double WIDTH = 1.5;
  private static final double HEIGHT = 0.75;
  private static final double DEPTH = 0.4;

  private Credenza() {}

  static ParametricModel model() {
    double front = DEPTH / 2;
    double door = HEIGHT - 0.13;
    TriangleMesh grip = BoxBuilder.plain(0.022, 0.16, 0.006).move(0.66, 0.36, front + 0.015);
    return ParametricModel.of(
        "credenza",
        Part.of(
            "body",
            WoodMaterials.VENEER,
            BoxBuilder.bevelled(WIDTH, HEIGHT - 0.07, DEPTH, 0.006, 1).move(0, 0.07, 0)),
        Part.of("plinth", Materials.BLACK, BoxBuilder.plain(WIDTH - 0.06, 0.07, DEPTH - 0.06)),
        Part.of(
            "doors",
            Materials.CREAM_LACQUER,
            BoxBuilder.plain(0.74, door, 0.012).move(0.36, 0.1, front + 0.006),
            BoxBuilder.plain(0.74, door, 0.005).move(-0.36, 0.1, front + 0.0025)),
        Part.of("grips", Materials.DARK_STEEL, grip, grip.move(-1.32, 0, -0.007)));
  }
}
