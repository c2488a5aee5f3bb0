package org.selectiverenderer.apartment.lounge;

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
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** An open pack of cigarettes, a lighter that stands beside it, and two cigarettes before them. */
final class CigaretteSet {
  private static final double PACK = -0.035;
  private static final double LIGHTER = 0.03;

  private CigaretteSet() {}

  static ParametricModel model() {
    ModelMaterial card = ModelMaterial.satin(ModelColour.of(0.9, 0.89, 0.86));
    ModelMaterial red = ModelMaterial.satin(ModelColour.of(0.66, 0.1, 0.1));
    ModelMaterial cork = ModelMaterial.matt(ModelColour.of(0.8, 0.55, 0.3));
    ModelMaterial fluid = ModelMaterial.glossy(ModelColour.of(0.1, 0.3, 0.5));
    return ModelPlacement.centred(
        ParametricModel.of(
            "cigaretteSet",
            Part.of("pack", card, BoxBuilder.plain(0.056, 0.04, 0.023).move(PACK, 0, 0), emblem()),
            Part.of("flap", red, shoulder(), lid()),
            Part.of("paper", Materials.CREAM_PAPER, loose(0.004, 0.059, 0)),
            Part.of("filters", cork, inPack(), loose(0.0041, 0.025, 0.059)),
            Part.of("lighter", fluid, lighter()),
            Part.of("lightersHead", Materials.STEEL, head())));
  }

  /** Returns the pack's red upper half, whose front comes down in a point. */
  private static TriangleMesh shoulder() {
    return BoxBuilder.plain(0.056, 0.024, 0.023).move(PACK, 0.04, 0);
  }

  private static TriangleMesh emblem() {
    SimplePolygon shield =
        SimplePolygon.of(-0.012, 0.012, -0.012, -0.002, 0, -0.012, 0.012, -0.002, 0.012, 0.012);
    return ExtrudedSolid.plain(0.0006, shield).move(PACK, 0.05, 0.0115);
  }

  private static TriangleMesh lid() {
    return BoxBuilder.plain(0.056, 0.024, 0.023)
        .move(0, 0, 0.0115)
        .turnX(-105)
        .move(PACK, 0.063, -0.0115);
  }

  private static TriangleMesh inPack() {
    TriangleMesh row =
        MeshPatterns.row(RoundSolidBuilder.cylinder(0.0036, 0.022, 8), 7, 0.0077, 0, 0);
    TriangleMesh pulled = RoundSolidBuilder.cylinder(0.0036, 0.018, 8).move(0.0077, 0.014, 0);
    return row.append(pulled).move(PACK - 0.0231, 0.052, 0.003);
  }

  /** Returns a section of each of the two cigarettes on the table. */
  private static TriangleMesh loose(double radius, double length, double from) {
    TriangleMesh lying =
        RoundSolidBuilder.cylinder(radius, length, 14).turnX(90).move(0, 0.0041, from);
    return TriangleMesh.of(
        lying.turnY(78).move(-0.05, 0, 0.034), lying.turnY(118).move(-0.035, 0, 0.062));
  }

  private static TriangleMesh lighter() {
    return ExtrudedSolid.plate(0.058, 0.001, 1, SimplePolygon.ellipse(0.0125, 0.0065, 20))
        .move(LIGHTER, 0, 0);
  }

  private static TriangleMesh head() {
    TriangleMesh collar =
        ExtrudedSolid.plate(0.013, 0, 0, SimplePolygon.ellipse(0.0118, 0.006, 14))
            .move(LIGHTER, 0.058, 0);
    TriangleMesh wheel =
        RoundSolidBuilder.cylinder(0.0045, 0.006, 10)
            .turnX(90)
            .move(LIGHTER + 0.004, 0.0715, -0.003);
    TriangleMesh thumb =
        BoxBuilder.plain(0.009, 0.004, 0.007).turnZ(-14).move(LIGHTER - 0.008, 0.07, 0);
    return TriangleMesh.of(collar, wheel, thumb);
  }
}
