package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * A desk dispenser of sticky tape, 0.17 m long, seen from its side: two cheeks hold the roll, its
 * end lies on a toothed blade at the right (thesis Fig 71).
 */
final class Selotape {
  private static final int SEGMENTS = 160;
  private static final double AXLE_X = -0.028;
  private static final double AXLE_Y = 0.045;

  private Selotape() {}

  static ParametricModel model() {
    ModelMaterial tape = ModelMaterial.glossy(ModelColour.of(0.83, 0.73, 0.42));
    ModelMaterial core = ModelMaterial.matt(ModelColour.of(0.72, 0.6, 0.45));
    return ModelPlacement.centred(
        ParametricModel.of(
            "selotape",
            Part.of("cheeks", Materials.BLUE, cheek(), cheek().mirrorZ(), saddle()),
            Part.of("sole", Materials.RUBBER, sole()),
            Part.of("tape", tape, roll(0.0195, 0.037, 0.019, 0.0012, 8), strip()),
            Part.of("core", core, roll(0.0175, 0.0196, 0.0205, 0.0007, 6)),
            Part.of("hub", Materials.SILVER, hub(), cap(), cap().mirrorZ()),
            Part.of("blade", Materials.CHROME, blade())));
  }

  private static TriangleMesh cheek() {
    SimplePolygon side =
        ProfileCurve.from(-0.072, 0)
            .line(0.066, 0)
            .bezier(0.074, 0, 0.077, 0.004, 0.078, 0.012, 8)
            .line(0.084, 0.04)
            .bezier(0.0855, 0.049, 0.074, 0.05, 0.07, 0.042, 14)
            .bezier(0.058, 0.019, 0.034, 0.018, 0.02, 0.028, 28)
            .bezier(0.002, 0.042, -0.004, 0.064, -0.028, 0.064, 28)
            .bezier(-0.05, 0.064, -0.054, 0.038, -0.072, 0.026, 28)
            .bezier(-0.088, 0.016, -0.086, 0, -0.072, 0, 18)
            .closed();
    return ExtrudedSolid.bevelled(0.013, 0.0035, 7, side).move(0, 0, 0.0135);
  }

  /** Returns the part that joins the cheeks below the roll and carries the blade. */
  private static TriangleMesh saddle() {
    SimplePolygon side =
        ProfileCurve.from(-0.07, 0.0005)
            .line(0.07, 0.0005)
            .line(0.0765, 0.03)
            .line(0.078, 0.04)
            .bezier(0.07, 0.024, 0.05, 0.012, 0.03, 0.008, 16)
            .line(0.01, 0.005)
            .line(-0.07, 0.005)
            .closed();
    return ExtrudedSolid.plain(0.03, side).move(0, 0, -0.015);
  }

  private static TriangleMesh sole() {
    return ExtrudedSolid.plate(
            0.004, 0.001, 2, SimplePolygon.roundedRectangle(0.14, 0.048, 0.008, 8))
        .move(0, -0.002, 0);
  }

  private static TriangleMesh roll(
      double inner, double outer, double width, double edge, int steps) {
    SimplePolygon section =
        SimplePolygon.roundedRectangle(outer - inner, width, edge, steps)
            .move((inner + outer) / 2, 0);
    return MeshOrientation.forward(Lathe.ring(section, SEGMENTS)).move(AXLE_X, AXLE_Y, 0);
  }

  private static TriangleMesh hub() {
    ProfileCurve dished =
        ProfileCurve.from(0, -0.006)
            .line(0.007, -0.006)
            .arc(0.0115, -0.0125, -70, 6)
            .line(0.0174, -0.0105)
            .line(0.0174, 0.0105)
            .line(0.0155, 0.0105)
            .arc(0.0115, 0.0125, -70, 6)
            .line(0.007, 0.006)
            .line(0, 0.006);
    return MeshOrientation.forward(Lathe.solid(dished, SEGMENTS)).move(AXLE_X, AXLE_Y, 0);
  }

  private static TriangleMesh cap() {
    return MeshOrientation.forward(RoundSolidBuilder.roundedCylinder(0.009, 0.004, 0.002, 4, 64))
        .move(AXLE_X, AXLE_Y, 0.0255);
  }

  /** Returns the end of the tape, from the top of the roll over to the blade. */
  private static TriangleMesh strip() {
    ProfileCurve path =
        ProfileCurve.from(-0.018, 0.0805).bezier(0.01, 0.074, 0.05, 0.058, 0.087, 0.0495, 24);
    return Sweep.of(SimplePolygon.rectangle(0.0185, 0.0005), Spine.of(path));
  }

  private static TriangleMesh blade() {
    int teeth = 16;
    double width = 0.024;
    ProfileCurve edge = ProfileCurve.of(-width / 2, -0.012, width / 2, -0.012);
    for (int i = 0; i < teeth; i++) {
      double right = width / 2 - width * i / teeth;
      edge = edge.line(right, 0).line(right - width / 2 / teeth, 0.002);
    }
    return ExtrudedSolid.plain(0.001, edge.line(-width / 2, 0).closed())
        .turnY(90)
        .turnZ(-10)
        .move(0.0865, 0.046, 0);
  }
}
