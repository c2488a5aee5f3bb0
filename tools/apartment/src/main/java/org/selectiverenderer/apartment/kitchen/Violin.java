package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
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
 * A violin lying on its back, 0.6 m long, its scroll to the back (-z), and its bow at the right.
 * One of the objects that no kitchen is expected to have (thesis, Appendix B).
 */
final class Violin {
  private static final double TOP = 0.04;

  private Violin() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        "violin",
        Part.of("body", ModelMaterial.glossy(ModelColour.hex(0xA2552A)), body(), neck(), scroll()),
        Part.of("black", Materials.SOFT_BLACK, fingerboard(), tailpiece(), soundHoles(), pegs()),
        Part.of(
            "bridge", Materials.LIGHT_OAK, BoxBuilder.plain(0.04, 0.022, 0.004).move(0, TOP, 0.02)),
        Part.of("strings", Materials.POLISHED_STEEL, strings()),
        Part.of("bow", Materials.DARK_WOOD, stick()),
        Part.of(
            "hair",
            ModelMaterial.matt(ModelColour.hex(0xE8E2D0)),
            BoxBuilder.plain(0.006, 0.001, 0.66).move(0.162, 0.004, -0.05)));
  }

  /** Returns the body, seen from above with the neck upwards; its waist has corners. */
  private static TriangleMesh body() {
    SimplePolygon outline =
        ProfileCurve.from(0, -0.178)
            .spline(2, 0.06, -0.17, 0.1, -0.125, 0.1, -0.075)
            .line(0.078, -0.035)
            .spline(2, 0.057, -0.005, 0.058, 0.03, 0.074, 0.058)
            .line(0.083, 0.078)
            .spline(2, 0.083, 0.11, 0.062, 0.155, 0.022, 0.176)
            .line(0, 0.178)
            .closedWithMirrorX();
    return ExtrudedSolid.plate(TOP, 0.007, 1, outline);
  }

  private static TriangleMesh neck() {
    return Sweep.of(
        SimplePolygon.ellipse(0.012, 0.011, 8),
        Spine.of(0, 0.034, -0.165, 0, 0.04, -0.32, 0, 0.03, -0.38),
        t -> 1 - 0.2 * t);
  }

  private static TriangleMesh scroll() {
    TriangleMesh curl =
        RoundSolidBuilder.cylinder(0.017, 0.02, 12).turnZ(-90).move(-0.01, 0.024, -0.39);
    return curl.append(
        RoundSolidBuilder.cone(0.011, 0.007, 0.034, 10).turnZ(-90).move(-0.017, 0.024, -0.39));
  }

  private static TriangleMesh fingerboard() {
    SimplePolygon board = SimplePolygon.of(-0.021, 0.04, 0.021, 0.04, 0.012, 0.325, -0.012, 0.325);
    return ExtrudedSolid.plate(0.006, 0, 0, board).move(0, TOP + 0.008, 0);
  }

  private static TriangleMesh tailpiece() {
    SimplePolygon plate =
        SimplePolygon.of(-0.009, -0.175, 0.009, -0.175, 0.021, -0.07, -0.021, -0.07);
    return ExtrudedSolid.plate(0.006, 0, 0, plate)
        .move(0, TOP + 0.006, 0)
        .append(BoxBuilder.plain(0.01, 0.012, 0.01).move(0, TOP, 0.17));
  }

  /** Returns the two f-holes, as thin black inlays. */
  private static TriangleMesh soundHoles() {
    Spine f =
        Spine.of(
            0.042, TOP, 0.058, 0.049, TOP, 0.05, 0.043, TOP, 0.02, 0.036, TOP, -0.012, 0.042, TOP,
            -0.02);
    return MeshPatterns.bothSides(Sweep.of(SimplePolygon.rectangle(0.006, 0.0012), f));
  }

  private static TriangleMesh pegs() {
    TriangleMesh peg = RoundSolidBuilder.cone(0.003, 0.006, 0.03, 5);
    TriangleMesh right = peg.turnZ(-90).move(0.008, 0.034, -0.345);
    return MeshPatterns.bothSides(right.append(right.move(0, -0.003, -0.022)));
  }

  private static TriangleMesh strings() {
    TriangleMesh string =
        Sweep.tube(
            Spine.of(0, TOP + 0.012, 0.075, 0, TOP + 0.0235, 0.02, 0, TOP + 0.015, -0.325),
            0.0007,
            3);
    return MeshPatterns.row(string, 4, 0.009, 0, 0).move(-0.0135, 0, 0);
  }

  private static TriangleMesh stick() {
    Spine line =
        Spine.of(
            0.162, 0.018, 0.3, 0.162, 0.012, 0, 0.162, 0.012, -0.2, 0.162, 0.018, -0.37, 0.162,
            0.003, -0.385);
    TriangleMesh frog = BoxBuilder.plain(0.01, 0.016, 0.045).move(0.162, 0.001, 0.26);
    return Sweep.tube(line, 0.004, 6).append(frog);
  }
}
