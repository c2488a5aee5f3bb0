package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A framed painting, 1 m by 0.7 m: the sun over hills by the sea. Its back is flat. */
final class Painting {
  private static final double WIDTH = 0.94;
  private static final double HEIGHT = 0.64;

  private Painting() {}

  static ParametricModel model() {
    SimplePolygon middle = SimplePolygon.rectangle(WIDTH, HEIGHT);
    // The section's x points to the viewer, its y inwards.
    SimplePolygon moulding =
        SimplePolygon.of(0, -0.03, 0.024, -0.03, 0.03, -0.012, 0.018, 0.03, 0, 0.03);
    TriangleMesh frame = Sweep.of(moulding, Spine.of(middle));
    double x = WIDTH / 2 - 0.02;
    double y = HEIGHT / 2 - 0.02;
    SimplePolygon hills =
        ProfileCurve.from(-x, -0.06)
            .spline(3, -0.3, 0.05, -0.12, -0.03, 0.08, 0.07, 0.28, -0.02, x, -0.05)
            .line(x, -0.12)
            .line(-x, -0.12)
            .closed();
    SimplePolygon shore =
        ProfileCurve.from(-x, -0.2).spline(3, -0.15, -0.23, 0.1, -y).line(-x, -y).closed();
    SimplePolygon sun = SimplePolygon.circle(0.065, 12).move(0.2, 0.14);
    return ModelPlacement.centred(
        ParametricModel.of(
            "painting",
            Part.of("frame", Materials.PALE_BRASS, frame),
            Part.of(
                "sky",
                paint(0.95, 0.8, 0.62),
                BoxBuilder.plain(2 * x, 2 * y, 0.01).move(0, -y, 0.005)),
            Part.of("sun", paint(0.9, 0.45, 0.22), ExtrudedSolid.plain(0.012, sun)),
            Part.of(
                "sea",
                paint(0.24, 0.5, 0.56),
                ExtrudedSolid.plain(0.0125, SimplePolygon.of(-x, -y, x, -y, x, -0.1, -x, -0.1))),
            Part.of("hills", paint(0.42, 0.46, 0.52), ExtrudedSolid.plain(0.014, hills)),
            Part.of("shore", paint(0.8, 0.68, 0.46), ExtrudedSolid.plain(0.0155, shore))));
  }

  private static ModelMaterial paint(double red, double green, double blue) {
    return ModelMaterial.matt(ModelColour.of(red, green, blue));
  }
}
