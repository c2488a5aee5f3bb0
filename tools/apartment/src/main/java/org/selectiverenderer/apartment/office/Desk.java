package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * A desk, 1.6 m wide, 0.8 m deep, 0.74 m high: three drawers on the left, two steel legs on the
 * right. Its user sits at +z (thesis Fig 71).
 */
final class Desk {
  private static final double HEIGHT = 0.74;
  private static final double TOP = 0.034;
  private static final double UNDER = HEIGHT - TOP;

  private Desk() {}

  static ParametricModel model() {
    return ParametricModel.of(
        "desk",
        Part.of(
            "top", Materials.OAK, BoxBuilder.bevelled(1.6, TOP, 0.8, 0.008, 2).move(0, UNDER, 0)),
        Part.of("pedestal", Materials.DARK_OAK, pedestal(), panel()),
        Part.of("drawers", Materials.OAK, drawers()),
        Part.of("handles", Materials.CHROME, handles()),
        Part.of("legs", Materials.CHARCOAL, legs()));
  }

  private static TriangleMesh pedestal() {
    return BoxBuilder.plain(0.44, UNDER - 0.04, 0.7)
        .append(BoxBuilder.plain(0.4, 0.04, 0.62).move(0, -0.04, 0))
        .move(-0.54, 0.04, 0);
  }

  /** Returns the modesty panel. */
  private static TriangleMesh panel() {
    return BoxBuilder.plain(1.05, 0.42, 0.02).move(0.2, UNDER - 0.42, -0.3);
  }

  private static TriangleMesh drawers() {
    TriangleMesh drawer = BoxBuilder.plain(0.43, 0.21, 0.022);
    return MeshPatterns.row(drawer.move(-0.54, 0.046, 0.357), 3, 0, 0.218, 0);
  }

  private static TriangleMesh handles() {
    ProfileCurve arch =
        ProfileCurve.of(-0.075, 0, -0.07, 0.02, -0.055, 0.03, 0.055, 0.03, 0.07, 0.02, 0.075, 0);
    TriangleMesh handle = Sweep.tube(Spine.of(arch), 0.006, 5).turnX(90).move(-0.54, 0.19, 0.365);
    return MeshPatterns.row(handle, 3, 0, 0.218, 0);
  }

  private static TriangleMesh legs() {
    TriangleMesh leg = BoxBuilder.bevelled(0.05, UNDER, 0.05, 0.008, 1).move(0.74, 0, 0.34);
    TriangleMesh rail = BoxBuilder.plain(0.03, 0.05, 0.64).move(0.74, 0.12, 0);
    return TriangleMesh.of(leg, leg.mirrorZ(), rail);
  }
}
