package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
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

/**
 * A hair dryer lying on its side, blowing to the left, the handle towards the viewer. One of the
 * objects that no kitchen is expected to have (thesis, Appendix B).
 */
final class HairDryer {

  private HairDryer() {}

  static ParametricModel model() {
    ProfileCurve barrel =
        ProfileCurve.from(0.03, 0.205)
            .line(0.032, 0.2)
            .spline(2, 0.034, 0.14, 0.043, 0.075, 0.044, 0.035)
            .line(0.037, 0.008)
            .line(0.024, 0);
    TriangleMesh cable =
        Sweep.tube(
            Spine.smooth(
                2, -0.045, -0.036, 0.19, -0.03, -0.039, 0.225, 0.03, -0.04, 0.24, 0.1, -0.04, 0.2,
                0.13, -0.04, 0.1),
            0.004,
            5);
    return ModelPlacement.centred(
        "hairDryer",
        Part.of("body", ModelMaterial.glossy(ModelColour.hex(0x8E4A6B)), lying(barrel), handle()),
        Part.of("black", Materials.SOFT_BLACK, lying(nozzle()), lying(grille()), cable, button()));
  }

  /**
   * Returns the solid of a profile that runs along +x from the grille, turned so that the nozzle
   * points left.
   */
  private static TriangleMesh lying(ProfileCurve profile) {
    return Lathe.solid(profile.reversed(), 16).turnZ(90).move(0.08, 0, 0);
  }

  private static ProfileCurve nozzle() {
    return ProfileCurve.of(
        0, 0.215, 0.027, 0.215, 0.027, 0.235, 0.033, 0.235, 0.0345, 0.195, 0, 0.195);
  }

  private static ProfileCurve grille() {
    return ProfileCurve.of(0, 0.004, 0.02, 0.004, 0.026, -0.001, 0.018, -0.006, 0, -0.006);
  }

  private static TriangleMesh handle() {
    Spine line =
        Spine.of(
            0.02, 0, 0.02, 0.012, -0.004, 0.07, -0.01, -0.014, 0.12, -0.03, -0.024, 0.155, -0.042,
            -0.03, 0.176, -0.045, -0.031, 0.182);
    return Sweep.of(
        SimplePolygon.ellipse(0.021, 0.017, 10), line, t -> t > 0.9 ? 0.45 : 1.05 - 0.25 * t);
  }

  private static TriangleMesh button() {
    return BoxBuilder.plain(0.012, 0.012, 0.03).turnY(-18).move(0, 0.004, 0.095);
  }
}
