package org.selectiverenderer.radiosity.bake;

import java.util.Arrays;
import java.util.BitSet;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.radiosity.mesh.RadiosityMesh;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.DirectLightEstimator;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.texel.TwoSidedLightSelector;
import org.selectiverenderer.radiosity.trace.Ray;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/** Samples the irradiance on the facets around one vertex after the other. One per thread. */
final class VertexSampler {
  /**
   * A start point of a divided surface is covered when at least this share of its rays ends at
   * another body within {@link #NEAR} of the scene's extent, as behind a picture or under a carpet.
   */
  private static final double COVERED = 0.6;

  private static final double NEAR = 1.0 / 150;

  /**
   * How far start points spread from the vertex towards the other corners, as a share of the way.
   */
  private static final double SPREAD = 0.6;

  /** Least share of start points outside of solids; a vertex with a smaller share is buried. */
  private static final double BURIED = 0.08;

  /**
   * Area of the facets around a vertex up to which half of the rays are enough, as a share of the
   * square of the scene's extent.
   */
  private static final double SMALL = 2e-6;

  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final TwoSidedLightSelector sides;
  private final RadiosityMesh facets;
  private final BitSet divided;
  private final VertexGatherer.Samples samples;
  private final SceneTriangles triangles;
  private final Ray ray = new Ray();
  private final DirectLightEstimator shadows;
  private final double[] normal = new double[3];
  private final double[] start = new double[3];
  private final double[] place = new double[3];
  private final double[] direction = new double[3];
  private final double[] lamps = new double[3];
  private final double[] others = new double[3];
  private final double[] seen = new double[3];

  // Sum of light times area, of the areas with valid samples, and of all areas.
  private final double[] sum = new double[3];
  private double weight;
  private double wanted;

  private boolean everythingCounts;

  /** Bit i: whether lamp i shines on some facet at the vertex. */
  private long known;

  /**
   * @param divided the facets of divided surfaces
   */
  VertexSampler(
      RadiosityScene scene,
      RadiositySolution solution,
      TwoSidedLightSelector sides,
      RadiosityMesh facets,
      BitSet divided,
      VertexGatherer.Samples samples) {
    this.divided = divided;
    this.scene = scene;
    this.solution = solution;
    this.sides = sides;
    this.facets = facets;
    this.samples = samples;
    this.triangles = scene.triangles();
    this.shadows = new DirectLightEstimator(scene, ray);
  }

  long rays() {
    return ray.cast();
  }

  /**
   * Makes covered start points count from now on, too, and the other side where the lit side is
   * buried.
   */
  void countEverything() {
    everythingCounts = true;
  }

  /** Returns the largest number of rays for a vertex. */
  int most() {
    return samples.rays();
  }

  void begin() {
    Arrays.fill(sum, 0);
    weight = 0;
    wanted = 0;
    known = 0;
  }

  /**
   * Returns whether the facets around a vertex are so small that light hardly changes over them.
   */
  boolean small(int corner, int count) {
    return plane(corner / 3) * count < SMALL * scene.extent() * scene.extent();
  }

  /** Adds samples of a facet near one of its corners, on its lit side. */
  void sample(int corner, int from, int to) {
    int facet = corner / 3;
    double area = plane(facet);
    if (!(area > 0)) {
      return;
    }
    wanted += area;
    int source = facets.source()[facet];
    boolean behind = sides.behind(source);
    boolean lit = side(corner, area, from, to, behind);
    if (!lit && everythingCounts && triangles.twoSided()[source]) {
      side(corner, area, from, to, !behind);
    }
  }

  /** Adds samples of one side; returns false if nearly all of it is buried. */
  private boolean side(int corner, double area, int from, int to, boolean behind) {
    int facet = corner / 3;
    int version = triangles.version()[facets.source()[facet]];
    double sign = behind ? -1 : 1;
    for (int axis = 0; axis < 3; axis++) {
      normal[axis] *= sign;
    }
    Arrays.fill(lamps, 0);
    Arrays.fill(others, 0);
    long near = lampsNear(corner, from, version, behind);
    int valid = 0;
    int lit = 0;
    int groups = Math.max(1, (to - from) / samples.perStart());
    for (int group = 0; group < groups; group++) {
      int begin = from + group * (to - from) / groups;
      int end = from + (group + 1) * (to - from) / groups;
      int at = from / samples.perStart() + group;
      place(corner, samples.starts().x(at), samples.starts().y(at));
      for (int axis = 0; axis < 3; axis++) {
        start[axis] = place[axis] + scene.offset() * normal[axis];
      }
      if (!indirect(begin, end, facet, version)) {
        continue;
      }
      valid += end - begin;
      for (int i = begin; i < end; i++) {
        if ((i - from) % samples.lampEvery() == 0) {
          lit++;
          shadows.add(
              start, normal, version, samples.lamps().x(i), samples.lamps().y(i), near, lamps);
        }
      }
    }
    for (int axis = 0; axis < 3; axis++) {
      normal[axis] *= sign;
    }
    if (valid == 0) {
      return false;
    }
    double share = (double) valid / (to - from);
    if (!samples.regather()) {
      patch(facet, behind, solution.indirect(), others);
      valid = 1;
    }
    for (int c = 0; c < 3; c++) {
      double light = others[c] / valid + (lit == 0 ? 0 : lamps[c] / lit);
      sum[c] += area * share * light;
    }
    weight += area * share;
    return share > BURIED;
  }

  /**
   * Finds the lamps that may shine on a corner: those that the patch there sees, and those of which
   * one more shadow ray from the vertex reaches a point. Returns them as bits.
   */
  private long lampsNear(int corner, int i, int version, boolean behind) {
    place(corner, 0.5f, 0.5f);
    int source = facets.source()[corner / 3];
    SceneTriangles.weights(triangles.corners(), source, place, direction);
    int patch = solution.patches().at(source, direction[0], direction[1], behind);
    known |= solution.lampsOf()[patch];
    for (int axis = 0; axis < 3; axis++) {
      start[axis] = place[axis] + scene.offset() * normal[axis];
    }
    Arrays.fill(direction, 0);
    known |=
        shadows.add(
            start, normal, version, samples.lamps().y(i), samples.lamps().x(i), ~known, direction);
    return known;
  }

  /**
   * Casts the rays of one start point and adds the radiance that they meet. Returns false, and adds
   * nothing, if the start point lies inside of a solid, which one ray is enough to tell, or is
   * covered.
   */
  private boolean indirect(int begin, int end, int facet, int version) {
    Arrays.fill(seen, 0);
    int covered = 0;
    for (int i = begin; i < end; i++) {
      samples.directions().about(normal, i, direction);
      ray.from(start, direction);
      ray.length = Double.POSITIVE_INFINITY;
      ray.pass = samples.lamps().y(i);
      scene.visibility().nearest(ray, version);
      if (ray.triangle == Ray.NOTHING) {
        continue;
      }
      if (ray.behind && !triangles.twoSided()[ray.triangle]) {
        return false;
      }
      if (ray.length < NEAR * scene.extent() && divided.get(facet)) {
        int[] bodyOf = scene.bodyOf();
        covered += bodyOf[ray.triangle] == bodyOf[facets.source()[facet]] ? 0 : 1;
      }
      int at = 3 * solution.patches().at(ray.triangle, ray.u, ray.v, ray.behind);
      for (int c = 0; c < 3; c++) {
        seen[c] += Math.PI * (solution.reflected()[at + c] + solution.glow()[at + c]);
      }
    }
    if (covered >= COVERED * (end - begin) && covered > 1 && !everythingCounts) {
      return false;
    }
    for (int c = 0; c < 3 && samples.regather(); c++) {
      others[c] += seen[c];
    }
    return true;
  }

  /** Adds the light of the patch in the middle of a facet, without casting rays. */
  void patches(int corner) {
    int facet = corner / 3;
    double area = plane(facet);
    if (!(area > 0)) {
      return;
    }
    wanted += area;
    place(corner, 0.5f, 0.5f);
    int source = facets.source()[facet];
    int patch = patch(facet, sides.behind(source), solution.indirect(), lamps);
    if (solution.buried()[patch] && triangles.twoSided()[source]) {
      patch = patch(facet, !sides.behind(source), solution.indirect(), lamps);
    }
    if (solution.buried()[patch]) {
      return;
    }
    weight += area;
    for (int c = 0; c < 3; c++) {
      sum[c] += area * (solution.indirect()[3 * patch + c] + solution.direct()[3 * patch + c]);
    }
  }

  /** Returns the patch at the last sample point of a facet and adds its values. */
  private int patch(int facet, boolean behind, float[] values, double[] sum) {
    int source = facets.source()[facet];
    SceneTriangles.weights(triangles.corners(), source, place, direction);
    int patch = solution.patches().at(source, direction[0], direction[1], behind);
    for (int c = 0; c < 3; c++) {
      sum[c] += values[3 * patch + c];
    }
    return patch;
  }

  /** Writes the mean of the added samples; returns false if the vertex is buried. */
  boolean end(float[] out, int at) {
    if (!(weight > BURIED * wanted)) {
      return false;
    }
    for (int c = 0; c < 3; c++) {
      out[at + c] = (float) (sum[c] / weight);
    }
    return true;
  }

  /** Computes the normal of a facet; returns its area. */
  private double plane(int facet) {
    float[] c = facets.corners();
    int at = 9 * facet;
    TriangleMath.cross(
        c[at + 3] - c[at],
        c[at + 4] - c[at + 1],
        c[at + 5] - c[at + 2],
        c[at + 6] - c[at],
        c[at + 7] - c[at + 1],
        c[at + 8] - c[at + 2],
        normal);
    double length = TriangleMath.length(normal);
    for (int axis = 0; axis < 3 && length > 0; axis++) {
      normal[axis] /= length;
    }
    return length / 2;
  }

  /** Chooses a sample point on a facet, with a density that grows towards the corner. */
  private void place(int corner, double s, double t) {
    int facet = 9 * (corner / 3);
    int k = corner % 3;
    // Approximately the inverse of the cumulative distribution of the density 1 - r, where r is the
    // distance from the corner.
    double r = SPREAD * s * (0.5 + 0.5 * s);
    int a = facet + 3 * k;
    int b = facet + 3 * ((k + 1) % 3);
    int c = facet + 3 * ((k + 2) % 3);
    float[] all = facets.corners();
    double bottom = 1e-3 + 0.998 * r;
    for (int axis = 0; axis < 3; axis++) {
      double far = (1 - t) * all[b + axis] + t * all[c + axis];
      place[axis] = all[a + axis] + bottom * (far - all[a + axis]);
    }
  }
}
