package org.selectiverenderer.apartment.office;

import java.util.Arrays;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * A framed picture of hills at sunset, 0.9 m by 0.62 m; one version. It hangs: its back lies in the
 * plane z = 0 with its middle at the origin.
 */
final class Poster {

  private Poster() {}

  static ParametricModel model() {
    SimplePolygon section =
        SimplePolygon.of(0, -0.012, 0.02, -0.012, 0.024, -0.004, 0.016, 0.012, 0, 0.012);
    TriangleMesh frame = Sweep.of(section, Spine.of(SimplePolygon.rectangle(0.876, 0.596)));
    return ParametricModel.of(
        "poster",
        Part.of("frame", Materials.BLACK, frame),
        Part.of(
            "back", Materials.DARK_OAK, BoxBuilder.plain(0.87, 0.59, 0.008).move(0, -0.295, 0.004)),
        Part.of("mount", Materials.PAPER, layer(0.86, 0.58, 0, 1)),
        Part.of(
            "sky", ModelMaterial.matt(ModelColour.of(0.93, 0.72, 0.46)), layer(0.7, 0.42, 0, 2)),
        Part.of(
            "upperSky",
            ModelMaterial.matt(ModelColour.of(0.52, 0.64, 0.74)),
            layer(0.7, 0.16, 0.13, 3)),
        Part.of("sun", ModelMaterial.matt(ModelColour.of(0.98, 0.87, 0.6)), sun()),
        hills("far", 0.55, 0.45, 0.52, 5, 0.04, -0.02, 0.06, 0.01, 0.05, -0.03, 0.0),
        hills("middle", 0.3, 0.36, 0.4, 6, -0.07, -0.02, -0.05, -0.09, -0.03, 0.0, -0.04),
        hills("near", 0.16, 0.26, 0.2, 7, -0.1, -0.14, -0.12, -0.07, -0.1, -0.15, -0.12));
  }

  private static TriangleMesh layer(double width, double height, double y, int layer) {
    return MeshOrientation.flat(width, height).move(0, y, 0.008 + 0.0008 * layer);
  }

  private static TriangleMesh sun() {
    return ExtrudedSolid.face(SimplePolygon.circle(0.045, 14)).move(0.1, 0.075, 0.0111);
  }

  /** Returns a range of hills given by heights at equal distances. */
  private static Part hills(
      String name, double red, double green, double blue, int layer, double... heights) {
    double[] more = new double[2 * heights.length];
    for (int i = 0; i < heights.length; i++) {
      more[2 * i] = -0.35 + 0.7 * i / (heights.length - 1);
      more[2 * i + 1] = heights[i];
    }
    ProfileCurve ridge = ProfileCurve.from(more[0], more[1]);
    ridge = ridge.spline(2, Arrays.copyOfRange(more, 2, more.length));
    SimplePolygon shape = ridge.line(0.35, -0.21).line(-0.35, -0.21).closed();
    TriangleMesh mesh = ExtrudedSolid.face(shape).move(0, 0, 0.008 + 0.0008 * layer);
    return Part.of(name + "Hills", ModelMaterial.matt(ModelColour.of(red, green, blue)), mesh);
  }
}
