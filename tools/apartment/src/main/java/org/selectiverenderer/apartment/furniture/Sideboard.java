package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;

/** A sideboard on slanting legs, 1.8 m by 0.74 m: a door, three drawers, a door. */
final class Sideboard {
  private static final double WIDTH = 1.8;
  private static final double HEIGHT = 0.74;
  private static final double DEPTH = 0.4;
  private static final double LEG = 0.17;
  private static final double FRONT = 0.57;

  private Sideboard() {}

  static ParametricModel model() {
    TriangleMesh body = BoxBuilder.bevelled(WIDTH, HEIGHT - LEG, DEPTH, 0.008, 1).move(0, LEG, 0);
    TriangleMesh door = front(FRONT, HEIGHT - LEG - 0.06).move(0.585, LEG + 0.03, 0);
    TriangleMesh drawer = front(FRONT, 0.162).move(0, LEG + 0.03, 0);
    TriangleMesh grip = BoxBuilder.plain(0.14, 0.012, 0.018).move(0, 0, DEPTH / 2 + 0.025);
    TriangleMesh upright = grip.turnZ(90).move(0.345, HEIGHT - 0.2, 0);
    return ParametricModel.of(
        "sideboard",
        Part.of("body", Materials.DARK_WOOD, body),
        Part.of(
            "fronts",
            WoodMaterials.VENEER,
            MeshPatterns.bothSides(door),
            MeshPatterns.row(drawer, 3, 0, 0.174, 0)),
        Part.of(
            "grips",
            Materials.PALE_BRASS,
            MeshPatterns.bothSides(upright),
            MeshPatterns.row(grip.move(0, LEG + 0.105, 0), 3, 0, 0.174, 0)),
        Part.of(
            "legs",
            Materials.WALNUT,
            MeshPatterns.corners(leg(), WIDTH / 2 - 0.16, DEPTH / 2 - 0.08)));
  }

  /**
   * Returns a leg whose upper end lies in the body and whose lower end is cut level with the floor.
   */
  private static TriangleMesh leg() {
    return RoundSolidBuilder.cone(0.011, 0.02, LEG + 0.01, 4)
        .deform(p -> p.add(0.25 * (LEG - p.y), 0, 0.15 * (LEG - p.y)));
  }

  private static TriangleMesh front(double width, double height) {
    return BoxBuilder.plain(width, height, 0.016).move(0, 0, DEPTH / 2 + 0.008);
  }
}
