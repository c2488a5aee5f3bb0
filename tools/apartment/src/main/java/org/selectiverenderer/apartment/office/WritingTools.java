package org.selectiverenderer.apartment.office;

import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** Builds the contents of pencil holders, upright on y = 0 with the point up. */
final class WritingTools {
  private static final double RADIUS = 0.0042;

  private WritingTools() {}

  /** Returns the painted body of a pencil, 24 triangles. */
  static TriangleMesh pencil(double length) {
    return RoundSolidBuilder.cylinder(RADIUS, length, 6);
  }

  /** Returns the sharpened wood on top of the body, 24 triangles. */
  static TriangleMesh sharpenedWood(double length) {
    return RoundSolidBuilder.cone(RADIUS, 0.0014, 0.016, 6).move(0, length, 0);
  }

  /** Returns the lead on top of the wood, 12 triangles. */
  static TriangleMesh lead(double length) {
    return RoundSolidBuilder.cone(0.0014, 0, 0.005, 6).move(0, length + 0.016, 0);
  }

  /** Returns a ball-point pen with cap, {@code 12 segments} triangles. */
  static TriangleMesh pen(double length, int segments) {
    ProfileCurve profile =
        ProfileCurve.of(0.0035, 0, 0.0046, 0.004, 0.0046, length - 0.06)
            .line(0.0056, length - 0.058)
            .line(0.0056, length - 0.004)
            .line(0.004, length);
    return Lathe.solid(profile, segments);
  }

  /** Returns one loop of a pair of scissors about the origin, in the xy plane. */
  static TriangleMesh scissorsLoop(int steps, int sides) {
    Spine oval =
        Spine.smoothLoop(steps, 0.015, 0, 0, 0.01, 0.02, 0, -0.013, 0.004, 0, -0.006, -0.026, 0);
    return Sweep.tube(oval, 0.0042, sides);
  }

  /** Tilts a tool about its foot, which then stands off the middle. */
  static TriangleMesh lean(
      TriangleMesh tool, double foot, double degrees, double around, double height) {
    return tool.turnX(degrees).move(0, height, foot).turnY(around);
  }
}
