package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** The case of a {@link ComputerSet}, 0.17 m wide and 0.4 m high; its front lies at z = 0. */
final class Tower {

  private Tower() {}

  static ParametricModel model() {
    return ParametricModel.of(
        "tower",
        Part.of(
            "case",
            Materials.BLACK,
            BoxBuilder.bevelled(0.17, 0.38, 0.36, 0.006, 4).move(0, 0.012, -0.2)),
        Part.of("towerFront", Materials.CHARCOAL, front()),
        Part.of("drives", Materials.SILVER, drives()),
        Part.of("slots", Materials.RUBBER, slots(), sockets()),
        Part.of("powerButton", Materials.CHROME, button(0.011, 0.004)),
        Part.of("powerLight", Materials.lit(0.2, 0.55, 1), ring()),
        Part.of("towerFeet", Materials.RUBBER, feet()));
  }

  private static TriangleMesh front() {
    return ExtrudedSolid.bevelled(
            0.02, 0.007, 5, SimplePolygon.roundedRectangle(0.17, 0.38, 0.02, 8))
        .move(0, 0.202, -0.022);
  }

  /** Returns two disc drives with their buttons. */
  private static TriangleMesh drives() {
    TriangleMesh drive =
        BoxBuilder.bevelled(0.146, 0.038, 0.006, 0.0025, 3)
            .append(BoxBuilder.bevelled(0.014, 0.006, 0.006, 0.002, 3).move(0.055, 0.006, 0.003));
    return MeshPatterns.row(drive.move(0, 0.335, -0.003), 2, 0, -0.045, 0);
  }

  private static TriangleMesh slots() {
    TriangleMesh slot = BoxBuilder.bevelled(0.11, 0.006, 0.004, 0.0019, 3);
    return MeshPatterns.row(slot.move(0, 0.04, -0.003), 9, 0, 0.0115, 0)
        .append(BoxBuilder.plain(0.13, 0.002, 0.001).move(0, 0.349, 0.003))
        .append(BoxBuilder.plain(0.13, 0.002, 0.001).move(0, 0.304, 0.003));
  }

  private static TriangleMesh sockets() {
    return MeshPatterns.row(
        BoxBuilder.plain(0.014, 0.006, 0.002).move(-0.05, 0.2, -0.0015), 3, 0.022, 0, 0);
  }

  private static TriangleMesh button(double radius, double height) {
    return MeshOrientation.forward(RoundSolidBuilder.roundedCylinder(radius, height, 0.0018, 4, 48))
        .move(0, 0.245, -0.002);
  }

  private static TriangleMesh ring() {
    return MeshOrientation.forward(RoundSolidBuilder.torus(0.014, 0.0016, 48, 12))
        .move(0, 0.245, -0.002);
  }

  private static TriangleMesh feet() {
    return MeshPatterns.corners(
            RoundSolidBuilder.roundedCylinder(0.014, 0.014, 0.003, 2, 20), 0.065, 0.15)
        .move(0, 0, -0.19);
  }
}
