package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;

/** A round table on a column of steel, 0.9 m across. */
final class MeetingTable {
  private static final double RADIUS = 0.45;
  private static final double HEIGHT = 0.73;

  private MeetingTable() {}

  static ParametricModel model() {
    ProfileCurve top =
        ProfileCurve.of(
                RADIUS - 0.02, HEIGHT - 0.028, RADIUS, HEIGHT - 0.014, RADIUS - 0.004, HEIGHT)
            .line(0, HEIGHT);
    ProfileCurve foot =
        ProfileCurve.of(0.25, 0, 0.25, 0.012, 0.04, 0.03, 0.036, HEIGHT - 0.04)
            .line(0.12, HEIGHT - 0.027);
    return ParametricModel.of(
        "meetingTable",
        Part.of("top", Materials.LIGHT_OAK, Lathe.solid(top, 20)),
        Part.of("foot", Materials.STEEL, Lathe.solid(foot, 10)));
  }
}
