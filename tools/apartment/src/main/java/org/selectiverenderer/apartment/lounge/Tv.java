package org.selectiverenderer.apartment.lounge;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A flat television of 1.02 m by 0.7 m with its stand; slots for the sound, a ribbed back. */
final class Tv {
  private static final double WIDTH = 1.02;
  private static final double HEIGHT = 0.62;

  /** Height of the panel's middle above the stand's underside, metres. */
  private static final double MIDDLE = 0.4;

  private Tv() {}

  static ParametricModel model() {
    ModelMaterial lacquer = ModelMaterial.glossy(ModelColour.of(0.06, 0.06, 0.065));
    ModelMaterial off =
        ModelMaterial.glossy(ModelColour.of(0.1, 0.12, 0.15))
            .glowing(ModelColour.of(0.03, 0.04, 0.055));
    ModelMaterial light =
        ModelMaterial.matt(ModelColour.of(0.5, 0.05, 0.05)).glowing(ModelColour.of(0.8, 0.1, 0.08));
    return ModelPlacement.centred(
        ParametricModel.of(
            "tv",
            Part.of("frame", lacquer, frame(), stand()),
            Part.of("screen", off, screen()),
            Part.of("trim", Materials.STEEL, trim(), buttons()),
            Part.of("back", Materials.BLACK_PLASTIC, back()),
            Part.of(
                "light",
                light,
                RoundSolidBuilder.ellipsoid(0.004, 0.004, 0.002, 4, 8).move(0.46, 0.118, 0.03))));
  }

  private static TriangleMesh frame() {
    SimplePolygon outer = SimplePolygon.roundedRectangle(WIDTH, HEIGHT, 0.022, 7);
    SimplePolygon window = SimplePolygon.rectangle(WIDTH - 0.08, HEIGHT - 0.1).move(0, 0.012);
    return ExtrudedSolid.bevelled(0.05, 0.01, 4, outer, window).move(0, MIDDLE, -0.02);
  }

  /**
   * Returns the screen, a millimetre behind the frame's front and a little larger than its window.
   */
  private static TriangleMesh screen() {
    return ParametricSurface.of(
        1,
        1,
        (u, v) ->
            new Vector3d(
                (u - 0.5) * (WIDTH - 0.07), MIDDLE + 0.012 + (v - 0.5) * (HEIGHT - 0.09), 0.014));
  }

  /** Returns a polished line along the lower edge, and the maker's mark. */
  private static TriangleMesh trim() {
    Spine line =
        Spine.smooth(8, -0.44, 0.1, 0.03, -0.2, 0.097, 0.03, 0.2, 0.097, 0.03, 0.44, 0.1, 0.03);
    TriangleMesh mark = BoxBuilder.bevelled(0.05, 0.008, 0.004, 0.001, 2).move(0, 0.108, 0.03);
    return TriangleMesh.of(Sweep.tube(line, 0.0022, 6), mark);
  }

  private static TriangleMesh buttons() {
    TriangleMesh button = PushButtons.round(0.007, 0.003, 0.004, 2, 10).turnX(90);
    return MeshPatterns.row(button.move(0.34, 0.118, 0.03), 4, 0.024, 0, 0);
  }

  private static TriangleMesh stand() {
    SimplePolygon ellipse = SimplePolygon.superellipse(0.28, 0.125, 2.4, 40);
    TriangleMesh base = ExtrudedSolid.plate(0.018, 0.008, 4, ellipse);
    TriangleMesh neck = BoxBuilder.bevelled(0.16, 0.12, 0.035, 0.012, 3).move(0, 0.012, -0.01);
    return base.append(neck);
  }

  private static TriangleMesh back() {
    TriangleMesh hump =
        BoxBuilder.bevelled(0.8, 0.42, 0.07, 0.03, 3).move(0, MIDDLE - 0.21, -0.035);
    TriangleMesh rib =
        BoxBuilder.bevelled(0.018, 0.1, 0.012, 0.004, 1).move(0, MIDDLE + 0.06, -0.07);
    return hump.append(MeshPatterns.row(rib.move(-0.3, 0, 0), 21, 0.03, 0, 0));
  }
}
