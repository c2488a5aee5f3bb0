package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;

/** A wooden chest with a vaulted lid, iron hasps and a lock, 0.8 m wide. */
final class Chest {
  private static final double WIDTH = 0.8;
  private static final double DEPTH = 0.42;
  private static final double LID = 0.34;

  private Chest() {}

  static ParametricModel model() {
    TriangleMesh box = BoxBuilder.plain(WIDTH, LID - 0.005, DEPTH);
    TriangleMesh hasp =
        BoxBuilder.plain(0.045, 0.2, 0.01).move(0.25, LID - 0.15, DEPTH / 2 + 0.005);
    TriangleMesh lock = BoxBuilder.plain(0.08, 0.1, 0.014).move(0, LID - 0.08, DEPTH / 2 + 0.007);
    return ParametricModel.of(
        "chest",
        Part.of("box", Materials.OAK, box),
        Part.of("lid", Materials.OAK, lid().move(-WIDTH / 2, 0, 0)),
        Part.of("iron", Materials.DARK_STEEL, MeshPatterns.bothSides(hasp), lock));
  }

  /** Returns the lid from x = 0 to the right: an arch over the depth, flat below. */
  private static TriangleMesh lid() {
    double half = DEPTH / 2;
    SimplePolygon arch =
        ProfileCurve.of(-half, LID, half, LID, half, LID + 0.05)
            .spline(2, 0.6 * half, LID + 0.11, 0, LID + 0.13, -0.6 * half, LID + 0.11)
            .line(-half, LID + 0.05)
            .closed();
    return ExtrudedSolid.plain(WIDTH, arch).turnY(90);
  }
}
