package org.selectiverenderer.apartment.office;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.TextGeometry;

/**
 * A round wall clock, 0.32 m wide, at ten past ten (thesis Fig 71). It hangs: its back lies in the
 * plane z = 0 with its middle at the origin.
 */
final class Clock {
  private static final int SEGMENTS = 48;
  private static final double DIAL = 0.013;

  private Clock() {}

  static ParametricModel model() {
    SimplePolygon rim =
        SimplePolygon.of(
            0.138, 0, 0.158, 0, 0.16, 0.005, 0.16, 0.022, 0.156, 0.03, 0.148, 0.034, 0.141, 0.03,
            0.138, 0.02);
    return ParametricModel.of(
        "clock",
        Part.of("rim", Materials.CHARCOAL, MeshOrientation.forward(Lathe.ring(rim, SEGMENTS)))
            .crease(50),
        Part.of(
            "dial",
            Materials.PAPER,
            MeshOrientation.forward(RoundSolidBuilder.cylinder(0.139, DIAL, SEGMENTS))),
        Part.of("numerals", Materials.BLACK, numerals()),
        Part.of("ticks", Materials.BLACK, ticks()),
        Part.of("hands", Materials.BLACK, hand(0.075, 0.007, -305), hand(0.115, 0.005, -60)),
        Part.of("secondHand", Materials.RED, secondHand(), hub()));
  }

  private static TriangleMesh numerals() {
    TextGeometry letters = TextGeometry.bold();
    List<TriangleMesh> all = new ArrayList<>();
    for (int hour = 3; hour <= 12; hour += 3) {
      TriangleMesh numeral = letters.flat(Integer.toString(hour), 0.045);
      double x = 0.105 * DegreeMath.sin(30.0 * hour);
      double y = 0.105 * DegreeMath.cos(30.0 * hour);
      all.add(numeral.move(x, y, DIAL + 0.001));
    }
    return TriangleMesh.of(all);
  }

  private static TriangleMesh ticks() {
    List<TriangleMesh> all = new ArrayList<>();
    for (int hour = 1; hour < 12; hour++) {
      if (hour % 3 != 0) {
        TriangleMesh tick = BoxBuilder.plain(0.007, 0.024, 0.003).move(0, 0.104, DIAL);
        all.add(tick.turnZ(-30.0 * hour));
      }
    }
    return TriangleMesh.of(all);
  }

  private static TriangleMesh hand(double length, double width, double degrees) {
    SimplePolygon shape =
        SimplePolygon.of(
                -width * 0.6, -0.02, width * 0.6, -0.02, width, 0, 0.002, length, -0.002, length)
            .turn(degrees);
    return ExtrudedSolid.bevelled(0.003, 0.001, 1, shape).move(0, 0, DIAL + 0.002);
  }

  private static TriangleMesh secondHand() {
    return BoxBuilder.plain(0.0025, 0.15, 0.0015).move(0, -0.035, DIAL + 0.006).turnZ(-200);
  }

  private static TriangleMesh hub() {
    return MeshOrientation.forward(RoundSolidBuilder.roundedCylinder(0.008, 0.008, 0.003, 1, 16))
        .move(0, 0, DIAL);
  }
}
