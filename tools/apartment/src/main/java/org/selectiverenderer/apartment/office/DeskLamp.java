package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * A red lamp on two sprung arms, seen from its side, its light to the right: 0.43 m high (thesis
 * Fig 71). The reflector is an open surface.
 */
final class DeskLamp {
  private static final double[] FOOT = {0, 0.06};
  private static final double[] ELBOW = {-0.13, 0.285};
  private static final double[] HEAD = {0.11, 0.415};

  private DeskLamp() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        ParametricModel.of(
            "deskLamp",
            Part.of(
                "base",
                Materials.RED,
                RoundSolidBuilder.roundedCylinder(0.085, 0.022, 0.009, 5, 96)),
            Part.of(
                "post",
                Materials.CHROME,
                RoundSolidBuilder.cylinder(0.009, 0.05, 24).move(0, 0.018, 0)),
            Part.of("arms", Materials.CHROME, arm(FOOT, ELBOW), arm(ELBOW, HEAD)),
            Part.of("springs", Materials.SILVER, springs(FOOT, ELBOW, 0.1, 19)),
            Part.of("joints", Materials.BLACK, joint(FOOT), joint(ELBOW), joint(HEAD)),
            Part.of("button", Materials.BLACK, button()),
            Part.of("shade", Materials.RED, atHead(shade())).crease(50),
            Part.of("reflector", Materials.WHITE, atHead(reflector())).crease(60),
            Part.of("bulb", bulbLook(), atHead(bulb())),
            Part.of("cable", Materials.RUBBER, cable())));
  }

  private static ModelMaterial bulbLook() {
    return Materials.WHITE.glowing(ModelColour.of(0.95, 0.88, 0.65));
  }

  /** Returns an arm of two parallel bars. */
  private static TriangleMesh arm(double[] from, double[] to) {
    Spine line = Spine.of(from[0], from[1], 0.011, to[0], to[1], 0.011);
    TriangleMesh bar = Sweep.tube(line, 0.0042, 12);
    return bar.append(bar.mirrorZ());
  }

  /** Returns a spring outside of each bar, from the lower joint upwards. */
  private static TriangleMesh springs(double[] from, double[] to, double length, int turns) {
    double lean = DegreeMath.atan2(from[0] - to[0], to[1] - from[1]);
    TriangleMesh spring = Sweep.tube(Spine.helix(0.0075, length, turns, 16), 0.0013, 8);
    TriangleMesh placed = spring.move(-0.014, 0.03, 0.011).turnZ(lean).move(from[0], from[1], 0);
    return placed.append(placed.mirrorZ());
  }

  private static TriangleMesh joint(double[] at) {
    return MeshOrientation.forward(RoundSolidBuilder.roundedCylinder(0.015, 0.036, 0.004, 3, 32))
        .move(at[0], at[1], -0.018);
  }

  private static TriangleMesh button() {
    return RoundSolidBuilder.roundedCylinder(0.009, 0.007, 0.003, 3, 32).move(0.02, 0.021, 0.05);
  }

  /** Moves a mesh, whose axis goes through the origin, to the end of the upper arm. */
  private static TriangleMesh atHead(TriangleMesh mesh) {
    return mesh.turnZ(24).move(HEAD[0] + 0.018, HEAD[1] - 0.012, 0);
  }

  /** Returns the shade, a bell of sheet metal that opens downwards. */
  private static TriangleMesh shade() {
    ProfileCurve outside =
        ProfileCurve.from(0.078, -0.118)
            .bezier(0.074, -0.08, 0.06, -0.045, 0.032, -0.03, 14)
            .line(0.03, 0.01)
            .arc(0.022, 0.01, 70, 5)
            .line(0.014, 0.026)
            .line(0, 0.027);
    ProfileCurve inside =
        ProfileCurve.from(0, -0.02)
            .line(0.028, -0.033)
            .bezier(0.057, -0.047, 0.071, -0.08, 0.0755, -0.118, 10);
    return Lathe.solid(inside.then(outside), 64);
  }

  private static TriangleMesh reflector() {
    ProfileCurve profile =
        ProfileCurve.from(0.074, -0.117)
            .bezier(0.07, -0.08, 0.056, -0.049, 0.027, -0.0345, 12)
            .line(0.004, -0.0245);
    return Lathe.surface(profile, 64).flip();
  }

  private static TriangleMesh bulb() {
    return RoundSolidBuilder.ellipsoid(0.026, 0.034, 0.026, 18, 32).move(0, -0.068, 0);
  }

  private static TriangleMesh cable() {
    Spine path =
        Spine.smooth(
            6, -0.07, 0.006, 0, -0.1, 0.004, -0.005, -0.125, 0.003, -0.03, -0.13, 0.003, -0.08);
    return Sweep.tube(path, 0.003, 8);
  }
}
