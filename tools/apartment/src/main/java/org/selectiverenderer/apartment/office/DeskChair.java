package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A swivel chair with arms on five castors, 0.98 m high; one version. */
final class DeskChair {
  private static final double SEAT = 0.46;

  private DeskChair() {}

  static ParametricModel model() {
    return ParametricModel.of(
        "deskChair",
        Part.of("cushions", Materials.BLUE, seat(), back()).crease(70),
        Part.of("frame", Materials.BLACK, spine(), MeshPatterns.bothSides(arm())),
        Part.of("armPads", Materials.CHARCOAL, MeshPatterns.bothSides(pad())),
        Part.of(
            "column",
            Materials.CHROME,
            RoundSolidBuilder.cylinder(0.025, 0.24, 8).move(0, 0.19, 0)),
        Part.of("star", Materials.BLACK, MeshPatterns.around(leg(), 5), hub()),
        Part.of("castors", Materials.RUBBER, MeshPatterns.around(castor(), 5)));
  }

  private static TriangleMesh seat() {
    return RoundSolidBuilder.superellipsoid(0.245, 0.045, 0.235, 3, 3.2, 6, 16)
        .deform(p -> p.add(0, -0.35 * p.z * p.z - (p.z > 0.15 ? 0.1 * (p.z - 0.15) : 0), 0))
        .move(0, SEAT, 0.02);
  }

  /** Returns the back, curved around the sitter and leaning back. */
  private static TriangleMesh back() {
    return RoundSolidBuilder.superellipsoid(0.22, 0.235, 0.035, 3, 2.6, 7, 16)
        .deform(p -> p.add(0, 0, 1.1 * p.x * p.x))
        .turnX(-8)
        .move(0, SEAT + 0.29, -0.24);
  }

  private static TriangleMesh spine() {
    Spine bar =
        Spine.smooth(
            3,
            0,
            SEAT - 0.05,
            0.05,
            0,
            SEAT - 0.055,
            -0.16,
            0,
            SEAT + 0.02,
            -0.255,
            0,
            SEAT + 0.25,
            -0.278);
    TriangleMesh plate = BoxBuilder.plain(0.2, 0.025, 0.2).move(0, SEAT - 0.06, 0.02);
    return plate.append(Sweep.of(SimplePolygon.rectangle(0.06, 0.02), bar));
  }

  private static TriangleMesh arm() {
    Spine bow =
        Spine.of(
            0.08,
            SEAT - 0.05,
            0.03,
            0.25,
            SEAT - 0.045,
            0.03,
            0.285,
            SEAT,
            0.02,
            0.285,
            SEAT + 0.2,
            -0.01);
    return Sweep.of(SimplePolygon.rectangle(0.022, 0.03), bow);
  }

  private static TriangleMesh pad() {
    return BoxBuilder.bevelled(0.06, 0.028, 0.26, 0.012, 1).move(0.285, SEAT + 0.195, 0.02);
  }

  /** Returns one of five legs, along +z, thinner and lower towards its end. */
  private static TriangleMesh leg() {
    return BoxBuilder.plain(0.05, 0.04, 0.27)
        .move(0, 0, 0.155)
        .deform(
            p -> p.set(p.x * (1.1 - 1.6 * p.z), 0.085 - 0.13 * p.z + p.y * (1 - 1.2 * p.z), p.z));
  }

  private static TriangleMesh hub() {
    return RoundSolidBuilder.cone(0.042, 0.034, 0.12, 8).move(0, 0.075, 0);
  }

  private static TriangleMesh castor() {
    TriangleMesh wheel = MeshOrientation.sideways(RoundSolidBuilder.cylinder(0.027, 0.044, 6));
    return wheel.move(-0.022, 0.027, 0.27);
  }
}
