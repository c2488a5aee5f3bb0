package org.selectiverenderer.apartment.lounge;

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
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A claw hammer that lies on its side, 0.33 m long; nobody expects it in a lounge. */
final class Hammer {

  private Hammer() {}

  static ParametricModel model() {
    ModelMaterial wood = ModelMaterial.satin(ModelColour.of(0.72, 0.5, 0.28));
    ModelMaterial grip = ModelMaterial.satin(ModelColour.of(0.6, 0.12, 0.1));
    return ModelPlacement.centred(
        ParametricModel.of(
            "hammer",
            Part.of("handle", wood, handle()).crease(60),
            Part.of("grip", grip, grip()).crease(60),
            Part.of("head", Materials.STEEL, face(), claw())));
  }

  /** Returns the handle along x, its head end at +x. */
  private static TriangleMesh handle() {
    return Sweep.of(
        SimplePolygon.ellipse(0.013, 0.0095, 8),
        Spine.smooth(1, -0.06, 0, 0, 0, 0, 0, 0.08, 0, 0, 0.168, 0, 0),
        t -> 0.85 + 0.15 * t);
  }

  private static TriangleMesh grip() {
    return Sweep.of(
        SimplePolygon.ellipse(0.016, 0.0125, 10),
        Spine.smooth(1, -0.165, 0, 0, -0.155, 0, 0, -0.11, 0, 0, -0.07, 0, 0, -0.05, 0, 0),
        t -> t == 0 ? 0.8 : t == 0.5 ? 1.05 : 0.93);
  }

  /** Returns the striking end: a neck and a round face towards +z. */
  private static TriangleMesh face() {
    ProfileCurve profile =
        ProfileCurve.of(0.012, -0.014, 0.012, 0.016, 0.0095, 0.026, 0.0135, 0.038, 0.0145, 0.05)
            .line(0.0125, 0.054);
    return Lathe.solid(profile, 10).turnX(90).move(0.15, 0, 0);
  }

  /** Returns the claw of two prongs, seen from above a bent wedge with a slot. */
  private static TriangleMesh claw() {
    TriangleMesh prong =
        Sweep.of(
            SimplePolygon.rectangle(0.016, 0.0105),
            Spine.smooth(
                2, 0.15, 0, 0, 0.15, 0, -0.028, 0.138, 0.002, -0.055, 0.112, 0.005, -0.078),
            t -> 1 - 0.72 * t);
    TriangleMesh upper = prong.move(0, 0.0056, 0);
    TriangleMesh eye = ExtrudedSolid.bevelled(0.03, 0.003, 1, SimplePolygon.circle(0.0165, 10));
    return TriangleMesh.of(upper, upper.scale(1, -1, 1), eye.move(0.15, 0, -0.016));
  }
}
