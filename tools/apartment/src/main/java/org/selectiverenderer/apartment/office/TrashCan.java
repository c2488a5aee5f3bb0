package org.selectiverenderer.apartment.office;

import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/**
 * A trash can of thin plastic with three ribs and a flared rim, 0.32 m high and 0.306 m wide: 28
 * steps of a wall with 18 bands and a centre below, and of a floor inside, 28 * (18 * 2 + 1 + 1) =
 * 1064 triangles (thesis Fig 71). The wall is one surface seen from both sides: an inner one so
 * near to it would come through when it is reduced.
 */
final class TrashCan {

  private TrashCan() {}

  static ParametricModel model() {
    ProfileCurve ribbedWall =
        ProfileCurve.of(0, 0.002, 0.1, 0, 0.106, 0, 0.111, 0.004)
            .line(0.1160, 0.050)
            .line(0.1214, 0.061)
            .line(0.1224, 0.071)
            .line(0.1194, 0.082)
            .line(0.1255, 0.138)
            .line(0.1309, 0.149)
            .line(0.1319, 0.159)
            .line(0.1289, 0.170)
            .line(0.1350, 0.226)
            .line(0.1404, 0.237)
            .line(0.1414, 0.247)
            .line(0.1384, 0.258);
    ProfileCurve rim = ProfileCurve.of(0.1420, 0.288, 0.1475, 0.297, 0.1520, 0.308, 0.153, 0.32);
    ProfileCurve floor = ProfileCurve.of(0.1, 0.014, 0, 0.014);
    ModelMaterial plastic =
        new ModelMaterial(
            ModelColour.of(0.3, 0.42, 0.5), ModelColour.grey(0.35), 0.35, 0, ModelColour.grey(0));
    return ParametricModel.of(
        "trashCan",
        Part.of(
            "body", plastic, Lathe.surface(ribbedWall.then(rim), 28), Lathe.surface(floor, 28)));
  }
}
