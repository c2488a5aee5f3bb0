package org.selectiverenderer.apartment.office;

import java.util.Arrays;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * The shape of a computer mouse, 0.115 m long, its buttons at +z.
 *
 * @param rings number of bands of the body from its back to its front, even
 * @param segments number of steps around the body
 */
record MouseShape(int rings, int segments) {
  private static final double HALF_WIDTH = 0.031;
  private static final double HEIGHT = 0.036;
  private static final double HALF_LENGTH = 0.0575;
  private static final double ALONG = 2.7;
  private static final double AROUND = 2.3;
  private static final double SOLE = 0.12;

  /** Returns the part under the palm, with a border in the middle, where the buttons begin. */
  TriangleMesh palm() {
    TriangleMesh body = body();
    int half = body.triangles().length / 2;
    return new TriangleMesh(body.positions(), Arrays.copyOf(body.triangles(), half));
  }

  /** Returns the part with the buttons, open where the palm's part begins. */
  TriangleMesh buttons() {
    TriangleMesh body = body();
    int[] all = body.triangles();
    return new TriangleMesh(body.positions(), Arrays.copyOfRange(all, all.length / 2, all.length));
  }

  private TriangleMesh body() {
    TriangleMesh egg =
        RoundSolidBuilder.superellipsoid(
            HALF_WIDTH, HALF_LENGTH, HEIGHT, ALONG, AROUND, rings, segments);
    return MeshOrientation.forward(egg)
        .deform(p -> p.mul(waist(p.z), p.y < 0 ? SOLE : slope(p.z), 1))
        .move(0, SOLE * HEIGHT, 0);
  }

  /** Returns the height profile, lower towards the buttons. */
  private static double slope(double z) {
    return 0.85 - 0.3 * z / HALF_LENGTH;
  }

  /** Returns the width profile, narrower where thumb and little finger hold the mouse. */
  private static double waist(double z) {
    double along = (z - 0.008) / HALF_LENGTH;
    return 0.88 + 0.12 * Math.min(1, along * along * 1.5);
  }

  /** Returns the height of the body's upper side along its middle. */
  private static double top(double z) {
    double width = 1 - DegreeMath.power(Math.abs(z) / HALF_LENGTH, ALONG);
    return HEIGHT * (SOLE + slope(z) * DegreeMath.power(width, 1 / ALONG));
  }

  /** Returns the dark line between the buttons. */
  TriangleMesh seam(int steps) {
    double[] along = new double[3 * (steps + 1)];
    for (int i = 0; i <= steps; i++) {
      double z = 0.052 * i / steps;
      along[3 * i + 1] = top(z) - 0.002;
      along[3 * i + 2] = z;
    }
    return Sweep.of(SimplePolygon.rectangle(0.0018, 0.0052), Spine.of(along));
  }

  TriangleMesh wheel(int steps, int around) {
    double z = 0.03;
    return MeshOrientation.sideways(RoundSolidBuilder.torus(0.0075, 0.0036, steps, around))
        .move(0, top(z) - 0.005, z);
  }

  /** Returns a cable that leaves between the buttons and runs through the points. */
  TriangleMesh cable(int steps, int sides, double... points) {
    double[] all = new double[points.length + 6];
    all[1] = 0.009;
    all[2] = 0.05;
    all[4] = 0.006;
    all[5] = 0.068;
    System.arraycopy(points, 0, all, 6, points.length);
    return Sweep.tube(Spine.smooth(steps, all), 0.0021, sides);
  }
}
