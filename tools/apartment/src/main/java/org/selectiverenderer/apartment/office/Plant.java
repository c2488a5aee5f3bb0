package org.selectiverenderer.apartment.office;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * A yucca in a pot, 1.24 m high: three canes of different height, each with a head of long arching
 * leaves (thesis Fig 71).
 */
final class Plant {
  /** x, height, z of the canes' tops, and the number of leaves there. */
  private static final double[][] HEADS = {
    {0.03, 1.02, -0.04, 27}, {-0.1, 0.76, 0.03, 24}, {0.1, 0.56, 0.07, 21}
  };

  private static final double GOLDEN_ANGLE = 137.5;

  private Plant() {}

  static ParametricModel model() {
    ProfileCurve pot =
        ProfileCurve.of(0.105, 0, 0.112, 0.006, 0.142, 0.235, 0.153, 0.24, 0.156, 0.275, 0.15, 0.28)
            .line(0.14, 0.277)
            .line(0.134, 0.235);
    List<TriangleMesh> canes = new ArrayList<>();
    List<TriangleMesh> young = new ArrayList<>();
    List<TriangleMesh> old = new ArrayList<>();
    for (double[] head : HEADS) {
      canes.add(cane(head));
      for (int i = 0; i < head[3]; i++) {
        double age = i / (head[3] - 1);
        TriangleMesh leaf = leaf(0.24 + 0.2 * age, 82 - 72 * age, 25 + 75 * age);
        (i % 3 == 0 ? young : old)
            .add(leaf.turnY(GOLDEN_ANGLE * i).move(head[0], head[1] - 0.05 * age, head[2]));
      }
    }
    return ParametricModel.of(
        "plant",
        Part.of("pot", Materials.WHITE, Lathe.solid(pot, 40)),
        Part.of("soil", soilLook(), soil()),
        Part.of(
            "canes", ModelMaterial.matt(ModelColour.of(0.46, 0.34, 0.22)), TriangleMesh.of(canes)),
        Part.of("youngLeaves", leaves(0.3, 0.52, 0.18), TriangleMesh.of(young)).crease(40),
        Part.of("oldLeaves", leaves(0.16, 0.38, 0.13), TriangleMesh.of(old)).crease(40));
  }

  private static ModelMaterial leaves(double red, double green, double blue) {
    return ModelMaterial.satin(ModelColour.of(red, green, blue));
  }

  private static ModelMaterial soilLook() {
    return ModelMaterial.matt(ModelColour.of(0.2, 0.13, 0.08));
  }

  private static TriangleMesh soil() {
    return RoundSolidBuilder.roundedCylinder(0.138, 0.05, 0.02, 2, 40).move(0, 0.205, 0);
  }

  private static TriangleMesh cane(double[] head) {
    Spine path =
        Spine.smooth(
            4,
            head[0] * 0.5,
            0.22,
            head[2] * 0.5,
            head[0] * 0.7,
            0.35,
            head[2] * 0.8,
            head[0],
            head[1] - 0.03,
            head[2]);
    return Sweep.tube(path, 12, t -> 0.024 - 0.006 * t);
  }

  /**
   * Returns a leaf that grows to +x, folded along its middle.
   *
   * @param rise angle above the horizontal at its root, degrees
   * @param droop angle by which it has bent down at its tip, degrees
   */
  private static TriangleMesh leaf(double length, double rise, double droop) {
    double radius = length / Math.toRadians(droop);
    TriangleMesh blade =
        ParametricSurface.of(
            9,
            2,
            (u, v) -> {
              double out = radius * (DegreeMath.sin(rise) - DegreeMath.sin(rise - droop * u));
              double up = radius * (DegreeMath.cos(rise - droop * u) - DegreeMath.cos(rise));
              double side = 0.058 * (v - 0.5) * (0.45 + 1.4 * u) * (1.002 - u * u);
              return new Vector3d(out, up + 0.5 * Math.abs(side), -side);
            });
    return ParametricSurface.thicken(blade, 0, -0.0015, 0);
  }
}
