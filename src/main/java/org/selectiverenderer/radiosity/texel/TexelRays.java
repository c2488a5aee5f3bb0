package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.sampling.Directions;
import org.selectiverenderer.radiosity.sampling.PointSet;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.trace.Ray;

/** Rays from the middle of a texel, and on from where they end. One per thread. */
final class TexelRays {
  /** Different sets of directions: neighbours' errors must not agree. */
  private static final int SETS = 64;

  /** Directions flatter than this leave the triangle to its back. */
  private static final double FLAT = 0.005;

  private final LightScene scene;
  private final Sets sets;
  private final double[] bounced = new double[3];
  private final double[] hitNormal = new double[3];
  private TexelPlace place;
  private int first;

  /** The last one that was cast. */
  final Ray ray = new Ray();

  /** Where rays start, off the surface. */
  final double[] start = new double[3];

  /** The direction of the last one. */
  final double[] direction = new double[3];

  /** Directions that all share. */
  record Sets(Directions directions, PointSet passes, int rays) {
    static Sets of(int rays, int seed) {
      return new Sets(
          new Directions(new PointSet(SETS * rays, seed, 22)),
          new PointSet(SETS * rays, seed, 23),
          rays);
    }
  }

  TexelRays(LightScene scene, Sets sets) {
    this.scene = scene;
    this.sets = sets;
  }

  /** Rays of one set. */
  int most() {
    return sets.rays();
  }

  /**
   * Begins at a place, which must stay where it is.
   *
   * @param turn which set of directions
   */
  void begin(TexelPlace from, int turn) {
    place = from;
    first = (PointSet.hash(turn) & SETS - 1) * sets.rays();
    place.start(start);
  }

  /** Casts one of the set; false if it would leave behind the triangle. */
  boolean cast(int i) {
    return cast(i, Double.POSITIVE_INFINITY, sets.passes().x(first + i));
  }

  /** Likewise, up to a length; what lets through more than {@code pass} is passed. */
  boolean cast(int i, double length, double pass) {
    sets.directions().about(place.normal, first + i, direction);
    if (dot(direction, place.facing) < FLAT) {
      return false;
    }
    send(start, place.version, length, pass);
    return true;
  }

  /** Casts one back to the surface. */
  void castBack(double length) {
    for (int axis = 0; axis < 3; axis++) {
      direction[axis] = -place.facing[axis];
    }
    send(start, place.version, length, 0.5);
  }

  /** Whether what the ray has met is seen from both sides. */
  boolean twoSided() {
    return scene.triangles().twoSided()[ray.triangle];
  }

  /**
   * Sends a ray of the set on from where it has ended; false if it meets nothing that has light.
   *
   * @param bounce how often it has been sent on
   */
  boolean bounce(int i, int bounce) {
    faceHit();
    bounced[0] = ray.ox + ray.length * ray.dx + scene.offset() * hitNormal[0];
    bounced[1] = ray.oy + ray.length * ray.dy + scene.offset() * hitNormal[1];
    bounced[2] = ray.oz + ray.length * ray.dz + scene.offset() * hitNormal[2];
    return sendOn(i, bounce);
  }

  /**
   * Likewise from before where it has ended: off the surface there may be another one, in a gap
   * that is less than an offset wide.
   */
  boolean turnBack(int i, int bounce) {
    double length = ray.length - Math.min(scene.offset(), ray.length) / 2;
    bounced[0] = ray.ox + length * ray.dx;
    bounced[1] = ray.oy + length * ray.dy;
    bounced[2] = ray.oz + length * ray.dz;
    faceHit();
    return sendOn(i, bounce);
  }

  private void faceHit() {
    scene.triangles().normal(ray.triangle, hitNormal);
    for (int axis = 0; axis < 3; axis++) {
      hitNormal[axis] *= ray.behind ? -1 : 1;
    }
  }

  private boolean sendOn(int i, int bounce) {
    int turn = PointSet.hash(first + i + 0x632be5ab * (bounce + 1));
    int next = (turn >>> 1) % sets.directions().size();
    sets.directions().about(hitNormal, next, direction);
    send(bounced, place.version, Double.POSITIVE_INFINITY, sets.passes().y(next));
    return ray.triangle != Ray.NOTHING && (!ray.behind || twoSided());
  }

  private void send(double[] from, int version, double length, double pass) {
    ray.from(from, direction);
    ray.length = length;
    ray.pass = pass;
    scene.visibility().nearest(ray, version);
  }

  static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
}
