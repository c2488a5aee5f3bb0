package org.selectiverenderer.apartment.office;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;
import org.selectiverenderer.modelling.TextGeometry;

/**
 * A desk telephone, 0.2 m wide: handset on the left, keys and display on the right, a coiled cord
 * (thesis Fig 71). The digits on its keys are open surfaces.
 */
final class TelephoneLibrary {
  private static final double SLOPE = 13.24;
  private static final double KEY_TOP = 0.0055;

  private TelephoneLibrary() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        ParametricModel.of(
            "telephoneLibrary",
            Part.of("body", Materials.CHARCOAL, body(), cradle(-0.072), cradle(0.058)),
            Part.of("handset", Materials.BLACK, handset()).crease(50),
            Part.of("cord", Materials.BLACK, cord()),
            Part.of("keys", Materials.SILVER, grid(4, 3, 0.021, 0.0165, 0.04, 0.006)),
            Part.of("functionKeys", Materials.GREY, grid(1, 4, 0.0205, 0, 0.04, -0.026)),
            Part.of("lineKeys", Materials.BLUE, grid(1, 3, 0.0275, 0, 0.04, 0.074)),
            Part.of("digits", Materials.BLACK, digits()),
            Part.of("displayFrame", Materials.BLACK, displayFrame()),
            Part.of("display", Materials.lit(0.42, 0.52, 0.4), onFace(display(), 0.04, -0.054)),
            Part.of("feet", Materials.RUBBER, feet())));
  }

  /** Returns the body, a wedge that slopes down to the front. */
  private static TriangleMesh body() {
    SimplePolygon side =
        SimplePolygon.of(-0.095, 0.003, 0.098, 0.003, 0.098, 0.0213, -0.075, 0.062, -0.095, 0.056)
            .rounded(0.009, 8);
    return MeshOrientation.across(ExtrudedSolid.bevelled(0.2, 0.006, 6, side), 0.2);
  }

  /** Moves a mesh that stands on y = 0 onto the sloping face. */
  private static TriangleMesh onFace(TriangleMesh mesh, double x, double z) {
    return mesh.turnX(SLOPE).move(x, 0.0444 - 0.2353 * z, z);
  }

  /** Returns the cradle of one end of the handset. */
  private static TriangleMesh cradle(double z) {
    return onFace(BoxBuilder.bevelled(0.052, 0.012, 0.05, 0.004, 5), -0.068, z);
  }

  private static TriangleMesh handset() {
    Spine arch =
        Spine.smooth(
            8, 0, 0.03, -0.094, 0, 0.038, -0.07, 0, 0.046, -0.035, 0, 0.048, 0, 0, 0.046, 0.035, 0,
            0.038, 0.07, 0, 0.03, 0.094);
    SimplePolygon section = SimplePolygon.superellipse(0.021, 0.0105, 2.8, 32);
    TriangleMesh grip =
        Sweep.of(section, arch, t -> 0.8 + 0.8 * Math.abs(t - 0.5) * Math.abs(t - 0.5));
    TriangleMesh cup =
        RoundSolidBuilder.roundedCylinder(0.0245, 0.027, 0.008, 6, 40).move(0, 0.009, 0);
    return onFace(
        TriangleMesh.of(grip, cup.move(0, 0, -0.072), cup.move(0, 0, 0.072)), -0.068, -0.004);
  }

  /** Returns the coiled cord from the handset's lower end to the left side. */
  private static TriangleMesh cord() {
    int turns = 17;
    int steps = 12;
    double[] way = {
      -0.072, 0.034, 0.095, -0.08, 0.012, 0.118, -0.103, 0.009, 0.12, -0.124, 0.009, 0.09, -0.124,
      0.009, 0.05, -0.098, 0.012, 0.02
    };
    List<Vector3d> path = Spine.smooth(turns * steps / 5, way).points();
    List<Vector3d> coil = new ArrayList<>();
    for (int i = 0; i + 1 < path.size(); i++) {
      Vector3d ahead = new Vector3d(path.get(i + 1)).sub(path.get(i));
      Vector3d right = ahead.cross(0, 1, 0, new Vector3d()).normalize();
      Vector3d up = right.cross(ahead, new Vector3d()).normalize();
      double angle = 360.0 * i / steps;
      coil.add(
          new Vector3d(path.get(i))
              .fma(0.0055 * DegreeMath.cos(angle), right)
              .fma(0.0055 * DegreeMath.sin(angle), up));
    }
    return Sweep.tube(new Spine(coil, false), 0.0017, 8);
  }

  /** Returns rows and columns of keys about a point of the face. */
  private static TriangleMesh grid(
      int rows, int columns, double dx, double dz, double x, double z) {
    TriangleMesh key = BoxBuilder.bevelled(dx - 0.006, KEY_TOP, 0.0105, 0.0025, 3);
    TriangleMesh row = MeshPatterns.row(key, columns, dx, 0, 0).move(-dx * (columns - 1) / 2, 0, 0);
    return onFace(MeshPatterns.row(row, rows, 0, 0, dz), x, z);
  }

  private static TriangleMesh digits() {
    TextGeometry letters = TextGeometry.bold();
    List<TriangleMesh> all = new ArrayList<>();
    String order = "123456789*0#";
    for (int i = 0; i < order.length(); i++) {
      TriangleMesh digit = letters.flat(order.substring(i, i + 1), 0.0085).turnX(-90);
      all.add(digit.move(0.021 * (i % 3 - 1), KEY_TOP + 0.0003, 0.0165 * (i / 3)));
    }
    return onFace(TriangleMesh.of(all), 0.04, 0.006);
  }

  private static TriangleMesh displayFrame() {
    return onFace(
        ExtrudedSolid.plate(
            0.005,
            0.002,
            5,
            SimplePolygon.roundedRectangle(0.096, 0.034, 0.006, 8),
            SimplePolygon.roundedRectangle(0.082, 0.022, 0.002, 4)),
        0.04,
        -0.054);
  }

  private static TriangleMesh display() {
    return MeshOrientation.flat(0.085, 0.025).turnX(-90).move(0, 0.0012, 0);
  }

  private static TriangleMesh feet() {
    return MeshPatterns.corners(
        RoundSolidBuilder.roundedCylinder(0.008, 0.005, 0.0015, 2, 20), 0.08, 0.08);
  }
}
